#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace hada {

/// How far the rings of one stem depart from what pith, lobes and taper make of them: standing
/// waves in a box, h cos(pi i (x - x0) / X) cos(pi j (y - y0) / Y) cos(pi k (z - z0) / Z), added
/// up.
class Ripples {
 public:
  struct Box {
    std::array<double, 3> least{0.0, 0.0, 0.0};  // x0, y0, z0
    std::array<double, 3> sides{1.0, 1.0, 1.0};  // X, Y, Z
  };
  using Orders = std::array<int, 3>;  // half waves along each side: i, j, k

  Ripples() = default;
  Ripples(const Box& box, std::vector<Orders> orders)
      : heights(orders.size(), 0.0), box_(box), orders_(std::move(orders)) {
    for (const Orders& one : orders_) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        count_[axis] = std::max(count_[axis], std::size_t(one[axis]) + 1);
    }
  }

  std::vector<double> heights;  // h, one for each wave, mm of the effective radius

  const Box& box() const { return box_; }
  const std::vector<Orders>& orders() const { return orders_; }

  /// Calls `use(n, value, slopes)` for every wave, its height taken as 1.
  template <class Use>
  void each(const std::array<double, 3>& place, const Use& use) const {
    if (orders_.empty()) return;
    std::array<std::vector<double>, 3> wave, slope;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double angle = std::numbers::pi / box_.sides[axis];
      const double at = angle * (place[axis] - box_.least[axis]);
      for (std::size_t k = 0; k < count_[axis]; ++k) {
        wave[axis].push_back(std::cos(double(k) * at));
        slope[axis].push_back(-double(k) * angle * std::sin(double(k) * at));
      }
    }
    for (std::size_t n = 0; n < orders_.size(); ++n) {
      const auto i = std::size_t(orders_[n][0]), j = std::size_t(orders_[n][1]),
                 k = std::size_t(orders_[n][2]);
      const double x = wave[0][i], y = wave[1][j], z = wave[2][k];
      use(n, x * y * z, std::array{slope[0][i] * y * z, x * slope[1][j] * z, x * y * slope[2][k]});
    }
  }

  double height_at(const std::array<double, 3>& place) const {
    double sum = 0.0;
    each(place, [&](std::size_t n, double value, const auto&) { sum += heights[n] * value; });
    return sum;
  }

 private:
  Box box_;
  std::vector<Orders> orders_;
  std::array<std::size_t, 3> count_{1, 1, 1};
};

}  // namespace hada
