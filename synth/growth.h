#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/field.h"
#include "core/scalar.h"

namespace hada {

/// One way in which rings depart from circles: `order` bulges around the stem.
///
/// Its share grows from nothing at `from_mm` to all at `to_mm`; it is the same everywhere if both
/// are 0.
template <class T = double>
struct GrowthLobe {
  T order{2.0};
  T cosine{0.0};
  T sine{0.0};
  T from_mm{0.0};
  T to_mm{0.0};

  static constexpr auto fields() {
    using F = Field<GrowthLobe, T>;
    return std::array{
        F{"order", &GrowthLobe::order, 1.0, 64.0, Scale::linear, "", "bulges around the stem"},
        F{"cosine", &GrowthLobe::cosine, -0.9, 0.9, Scale::linear, "",
          "share of the radius by which rings are nearer where order times the angle is 0"},
        F{"sine", &GrowthLobe::sine, -0.9, 0.9, Scale::linear, "", "the same a quarter turn on"},
        F{"from_mm", &GrowthLobe::from_mm, 0.0, 1e6, Scale::linear, "mm",
          "distance from the pith where the lobe begins to grow"},
        F{"to_mm", &GrowthLobe::to_mm, 0.0, 1e6, Scale::linear, "mm",
          "distance where it is whole; 0: it is whole everywhere"},
    };
  }
};

/// How much of a lobe is there at distance `r` from the pith.
template <class T>
T share_at(const GrowthLobe<T>& lobe, const T& r) {
  if (value_of(lobe.to_mm) <= value_of(lobe.from_mm)) return T(1.0);
  const T share = (r - lobe.from_mm) / (lobe.to_mm - lobe.from_mm);
  if (value_of(share) <= 0.0) return T(0.0);
  return value_of(share) >= 1.0 ? T(1.0) : share;
}

/// The effective radius rho of the place at distance r and angle theta from the pith: what the
/// radius would be if the rings were circles.
///
/// rho = r (1 + sum over lobes of share(r) (c cos k theta + s sin k theta)). This is the inverse
/// function T(r, theta) of Kawai, section 4.4, up to the years of the rings.
template <class T>
T effective_radius(const std::vector<GrowthLobe<T>>& lobes, const T& r, const T& theta) {
  using std::cos;
  using std::sin;
  T factor(1.0);
  for (const auto& lobe : lobes) {
    const T angle = lobe.order * theta;
    factor += share_at(lobe, r) * (lobe.cosine * cos(angle) + lobe.sine * sin(angle));
  }
  return r * factor;
}

/// Growth in one direction, for many radii: lobes of the same reach are added up.
class GrowthRay {
 public:
  GrowthRay(const std::vector<GrowthLobe<>>& lobes, double theta) {
    std::vector<Turn> turns;  // an order comes again in lobes of other reach
    for (const auto& lobe : lobes) {
      const Turn& turn = turn_of(lobe.order, theta, turns);
      const double height = lobe.cosine * turn.cosine + lobe.sine * turn.sine;
      if (bulges_.empty() || bulges_.back().from_mm != lobe.from_mm ||
          bulges_.back().to_mm != lobe.to_mm) {
        bulges_.push_back(lobe);
        bulges_.back().cosine = 0.0;
      }
      bulges_.back().cosine += height;  // a lobe of any order in its direction of most height
    }
  }

  double effective_radius(double r) const {
    double factor = 1.0;
    for (const auto& bulge : bulges_) factor += share_at(bulge, r) * bulge.cosine;
    return r * factor;
  }

  /// The distance from the pith at which the effective radius is `rho`.
  double radius_at(double rho) const { return radius_at(rho, rho); }
  /// The same, found sooner if `r` is near it.
  double radius_at(double rho, double r) const {
    for (int round = 0; round < 20; ++round) {
      const double next = r > 0.0 ? rho * r / effective_radius(r) : 0.0;
      if (std::abs(next - r) <= 1e-7 * rho) return next;
      r = next;
    }
    return r;
  }

 private:
  struct Turn {
    double order, cosine, sine;
  };

  static const Turn& turn_of(double order, double theta, std::vector<Turn>& turns) {
    for (const Turn& turn : turns) {
      if (turn.order == order) return turn;
    }
    return turns.emplace_back(Turn{order, std::cos(order * theta), std::sin(order * theta)});
  }

  std::vector<GrowthLobe<>> bulges_;
};

}  // namespace hada
