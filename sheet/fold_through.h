#pragma once

#include <string>

#include "sheet/fold_log.h"

namespace hada {

/// A flat sheet with all layers under a line folded, or those of the step's faces alone.
///
/// What stays keeps the order of its layers if it can. What moves turns as one where the step says
/// so; else its folds may turn inside out, as in a reverse fold.
///
/// throws  Error with `where` if the sheet is not flat, the line crosses no paper, the paper would
///         tear or block itself
void fold_through(FoldState& state, const FoldStep& step, const std::string& where);

}  // namespace hada
