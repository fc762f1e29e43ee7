#pragma once

#include <array>
#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Pairs of faces of the sheet as it lies that pass through each other by more than `tolerance`.
/// Faces that lie on each other, or touch, do not.
std::vector<std::array<int, 2>> crossing_faces(const Sheet& sheet, double tolerance = 1e-6);

}  // namespace hada
