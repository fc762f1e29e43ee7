#pragma once

#include <string>
#include <vector>

#include "core/fold.h"
#include "sheet/fold_log.h"

namespace hada {

/// A folded model as a file: as it lies with the order of its layers, and its flat pattern.
FoldFile fold_model(const std::string& title, const FoldState& state);

/// The same with the states that led to it as further frames.
FoldFile fold_sequence(const std::string& title, const std::vector<FoldState>& states);

}  // namespace hada
