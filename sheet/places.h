#pragma once

#include <Eigen/Core>

#include "sheet/sheet.h"

namespace hada {

/// The face that holds a place of the flat sheet; -1 if it lies beside the paper.
int face_at(const Sheet& sheet, const Eigen::Vector2d& flat);

/// The place of the flat sheet that a place on a face is now, and the other way round.
Eigen::Vector2d flat_place(const Sheet& sheet, int face, const Eigen::Vector3d& place);
Eigen::Vector3d folded_place(const Sheet& sheet, int face, const Eigen::Vector2d& flat);

}  // namespace hada
