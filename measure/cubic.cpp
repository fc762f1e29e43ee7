#include "measure/cubic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hada {

// The weights are the polynomials of Lagrange. Those of OpenCV's cubic are not exact for a line.
Cubic cubic_at(double place, int count) {
  const int first = std::clamp(int(std::floor(place)) - 1, 0, count - 4);
  Cubic cubic{first, {1.0, 1.0, 1.0, 1.0}};
  for (int k = 0; k < 4; ++k) {
    for (int other = 0; other < 4; ++other) {
      if (other != k) cubic.weight[std::size_t(k)] *= (place - first - other) / (k - other);
    }
  }
  return cubic;
}

}  // namespace hada
