#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sheet/sheet.h"

namespace hada {

/// The face that holds a place of the flat sheet; -1 if it lies beside the paper.
int face_at(const Sheet& sheet, const Eigen::Vector2d& flat);

/// The faces that hold places of the flat sheet, and the same as a choice among all; empty where no
/// place is given.
/// throws  Error with `where` if one lies beside the paper
std::vector<int> faces_at(const Sheet& sheet, const std::vector<Eigen::Vector2d>& places,
                          const std::string& where);
std::vector<bool> chosen_faces(const Sheet& sheet, const std::vector<Eigen::Vector2d>& places,
                               const std::string& where);

/// How far a place of the flat sheet is from an edge.
double distance_to(const Sheet& sheet, int edge, const Eigen::Vector2d& flat);

/// The place of the flat sheet that a place on a face is now, and the other way round.
Eigen::Vector2d flat_place(const Sheet& sheet, int face, const Eigen::Vector3d& place);
Eigen::Vector3d folded_place(const Sheet& sheet, int face, const Eigen::Vector2d& flat);

}  // namespace hada
