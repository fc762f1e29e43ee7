#pragma once

#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Of each face the largest change of a distance between two corners, against the flat sheet, as a
/// share of that distance: 0 for paper that neither stretches nor bends.
std::vector<double> face_strains(const Sheet& sheet);

}  // namespace hada
