#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sheet/plate.h"
#include "sheet/pointer.h"
#include "sheet/sheet.h"

namespace hada {

/// How faces that lie on each other are piled up: of each face its place in the pile, 0 at the
/// bottom, and the way that is up there.
struct Stack {
  std::vector<int> level;
  std::vector<Eigen::Vector3d> up;  // unit length, across the face
};

/// The piles of a sheet as it lies. An order speaks of two faces for as long as both lie in one
/// plane; a pile that stands level has its up along z > 0.
Stack stack_of(const Sheet& sheet, const std::vector<FaceOrder>& order);

/// The same of any faces in space; `size` is that of the whole.
Stack stack_of(const std::vector<Plate>& plates, const std::vector<FaceOrder>& order, double size);

/// The nearest face on a line of sight; of those that lie on each other the one that is seen.
std::optional<Hit> seen(const Sheet& sheet, const Stack& stack, const Ray& ray);

}  // namespace hada
