#pragma once

#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Of each face the largest change of a distance between two corners, against the flat sheet, as a
/// share of that distance: 0 for paper that neither stretches nor bends.
std::vector<double> face_strains(const Sheet& sheet);

/// Of each face the largest distance of a corner from its plane, as a share of the sheet: a face
/// may bend visibly where its lengths hardly change.
std::vector<double> face_planarities(const Sheet& sheet);

}  // namespace hada
