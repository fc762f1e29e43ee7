#pragma once

#include <string>

#include "sheet/fold_log.h"

namespace hada {

/// A sheet with what lies to the left of a line turned about it: all layers together, or the flap
/// on top or at the bottom alone.
///
/// throws  Error with `where` if the line crosses no paper or does not part it, or none of the
/// flaps
///         is outermost
void turn_layers(FoldState& state, const FoldStep& step, const std::string& where);

}  // namespace hada
