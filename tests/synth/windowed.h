#pragma once

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "synth/noise_function.h"

namespace hada {

/// That `narrowed` multiplies an autocovariance by its window, to rounding.
template <class Covariance>
void expect_multiplied_by_window(const Covariance& covariance) {
  const GaussianWindow window{0.06, -0.02, 0.1};
  const auto narrow = narrowed(covariance, window);
  for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {0.3, 0.1}, {-1.1, 0.7}, {2.0, -0.5}}) {
    const double by =
        std::exp(-(window.xx * dx * dx + 2.0 * window.xy * dx * dy + window.yy * dy * dy));
    EXPECT_NEAR(value_at(narrow, dx, dy), by * value_at(covariance, dx, dy), 1e-13);
  }
}

}  // namespace hada
