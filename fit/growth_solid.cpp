#include "fit/growth_solid.h"

#include <cmath>

#include "core/quantile.h"
#include "fit/growth_local.h"

namespace hada {

Eigen::VectorXd GrowthSolid::state() const {
  Eigen::VectorXd state(size());
  const Eigen::VectorXd shape = packed(frame);
  state << shape.head<2>(), lean, taper, shape.tail(shape.size() - 2),
      Eigen::Map<const Eigen::VectorXd>(ripples.heights.data(),
                                        Eigen::Index(ripples.heights.size())),
      Eigen::Map<const Eigen::VectorXd>(radii.data(), Eigen::Index(radii.size()));
  return state;
}

void GrowthSolid::set_state(const Eigen::VectorXd& state) {
  Eigen::VectorXd shape(ripples_at() - 3);
  shape << state.head<2>(), state.segment(lobes_at(), ripples_at() - lobes_at());
  frame = unpacked(frame, shape);
  lean = state.segment<2>(2);
  taper = state[4];
  for (std::size_t n = 0; n < ripples.heights.size(); ++n)
    ripples.heights[n] = state[ripples_at() + Eigen::Index(n)];
  for (std::size_t k = 0; k < radii.size(); ++k) radii[k] = state[radii_at() + Eigen::Index(k)];
}

double usual_width(const GrowthSolid& solid) {
  std::vector<double> widths;
  for (std::size_t k = 1; k < solid.radii.size(); ++k)
    widths.push_back(solid.radii[k] - solid.radii[k - 1]);
  return widths.empty() ? HUGE_VAL : median(std::move(widths));
}

SolidLocal local_of(const GrowthSolid& solid, const StemVector& place, bool with_slopes) {
  const double z = place[2];
  GrowthFrame here = solid.frame;
  here.pith += solid.lean * z;
  const GrowthLocal flat = growth_at(here, {place[0], place[1]});
  const Eigen::Vector2d by_pith = flat.slopes.head<2>();
  SolidLocal local;
  local.rho = flat.rho + solid.taper * z;
  local.gradient << -by_pith, solid.lean.dot(by_pith) + solid.taper;
  if (with_slopes) {
    local.slopes.resize(solid.radii_at());
    local.slopes.head(solid.ripples_at()) << by_pith, z * by_pith, z,
        flat.slopes.tail(flat.slopes.size() - 2);
  }
  solid.ripples.each(place, [&](std::size_t n, double value, const auto& slope) {
    const double height = solid.ripples.heights[n];
    local.rho += height * value;
    for (std::size_t axis = 0; axis < 3; ++axis)
      local.gradient[Eigen::Index(axis)] += height * slope[axis];
    if (with_slopes) local.slopes[solid.ripples_at() + Eigen::Index(n)] = value;
  });
  return local;
}

double fibre_slope(const GrowthSolid& solid, const Cut& cut, const Eigen::Vector2d& place,
                   double turning) {
  const StemVector at = cut.at(place.x(), place.y());
  const Eigen::Vector3d gradient = local_of(solid, at, false).gradient;
  const Eigen::Vector2d arm = Eigen::Vector2d(at[0], at[1]) - solid.frame.pith - solid.lean * at[2];
  const Eigen::Vector2d outward = arm.normalized(), around(-outward.y(), outward.x());
  Eigen::Vector3d fibre;
  fibre << solid.lean + turning * around, 1.0;
  const double rising = gradient.head<2>().dot(outward);
  fibre.head<2>() -= gradient.dot(fibre) / std::max(rising, 0.1) * outward;
  const Eigen::Map<const Eigen::Vector3d> right(cut.right.data()), up(cut.up.data());
  return fibre.dot(right) / fibre.dot(up);
}

double rho_sigma(const GrowthSolid& solid, const SolidLocal& local) {
  const Eigen::Index inner = solid.radii_at();
  const auto shape = solid.covariance.topLeftCorner(inner, inner);
  return std::sqrt(std::max(0.0, local.slopes.dot(shape * local.slopes)));
}

double ring_sigma(const GrowthSolid& solid, const SolidLocal& local, std::size_t ring) {
  const Eigen::Index inner = solid.radii_at(), k = inner + Eigen::Index(ring);
  const auto shape = solid.covariance.topLeftCorner(inner, inner);
  const double variance = local.slopes.dot(shape * local.slopes) -
                          2.0 * local.slopes.dot(solid.covariance.col(k).head(inner)) +
                          solid.covariance(k, k);
  return std::sqrt(std::max(0.0, variance));
}

}  // namespace hada
