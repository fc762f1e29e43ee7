#pragma once

#include <array>

namespace hada {

/// The cubic through four neighbouring ones of values in equal steps, at a place between them:
/// sum of weight[k] value[first + k].
struct Cubic {
  int first = 0;
  std::array<double, 4> weight{};
};

/// place  in steps from the first of `count` values, at least four
Cubic cubic_at(double place, int count);

}  // namespace hada
