#pragma once

#include "mechanics/stocking.h"
#include "mechanics/wear.h"

namespace hada {

/// A stocking drawn over a leg with a foot and let go, as `worn` does with a tube. Its toe is
/// closed and its heel turns; the welt is held.
///
/// `options.courses` are the rounds of leg, foot and toe together, shared out by the length of
/// each; the heel has as many short rows as lie at the same distance around the heel of the body.
/// At rest rounds are `girth` of the girth of the ankle, and courses are `length` as far apart as
/// worn. `from_mm` is not read.
///
/// throws  Error as `FootPath` and `stocking_net` do, or if the options make no stocking
WornKnit worn_stocking(const Body& body, const WearOptions& options = {});

/// How the rounds of `worn_stocking` are shared out.
StockingShape stocking_for(const Body& body, const WearOptions& options);

}  // namespace hada
