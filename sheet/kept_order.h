#pragma once

#include <vector>

#include <Eigen/Core>

#include "sheet/sheet.h"

/// What is known of the order of layers, kept while a sheet is cut and moved.
namespace hada {

/// Orders after faces were cut by creases: parts lie over others as the whole did.
///
/// creases  what `insert_crease` gave back
std::vector<FaceOrder> split_orders(const Sheet& sheet, const std::vector<FaceOrder>& order,
                                    int faces_before, const std::vector<int>& creases);

/// Orders after a movement, of all pairs of faces that lie on each other now. Those that kept
/// together stay as they were; those that came together lie as they came.
///
/// shortly_before  where the vertices were when what came together was still apart
std::vector<FaceOrder> moved_orders(const Sheet& sheet, const std::vector<FaceOrder>& order,
                                    const std::vector<Eigen::Vector3d>& shortly_before);

/// Folds that are shut become mountains or valleys as their faces lie.
void shut_as_ordered(Sheet& sheet, const std::vector<FaceOrder>& order);

}  // namespace hada
