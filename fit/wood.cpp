#include "fit/wood.h"

#include <algorithm>
#include <cmath>

#include "fit/end_grain.h"
#include "fit/ring_colours.h"

namespace hada {
namespace {

// What a picture can say of a boundary whose light and dark share a pixel: anywhere within it.
constexpr double boundary_px = 0.35;
// Interpolation and the lattice move all edges of a direction alike, which no scatter shows.
constexpr double lattice_px = 0.03;
constexpr double well_seen = 0.5;  // share of the sectors of a ring

/// A sigma that says nothing: that of a field that may be anything within its bounds, at most as
/// large as ordinary wood differs.
Wood<> unknown() {
  Wood<> sigma;
  visit_fields(sigma, [](const std::string&, const auto& field, double& value) {
    value = (field.high - field.low) / std::sqrt(12.0);
  });
  sigma.cut_origin_mm = sigma.cut_right = sigma.cut_up = {0.0, 0.0, 0.0};  // the frame: by choice
  sigma.lobes.clear();
  return sigma;
}

std::vector<double> as_list(const std::array<double, 3>& colour) {
  return {colour.begin(), colour.end()};
}

void set_shape(Fit<Wood<>>& fit, const EndGrain& grain, double pitch) {
  const auto& [frame, radii, radii_sigma, pith_sigma, lobe_sigma, scatter, points, independent,
               covariance] = grain.shape;
  const double localised = boundary_px * pitch;
  fit.material.pith_mm = {frame.pith.x(), frame.pith.y()};
  const double lattice = lattice_px * pitch;
  fit.sigma.pith_mm = {std::hypot(pith_sigma.x(), lattice), std::hypot(pith_sigma.y(), lattice)};
  fit.material.lobes = frame.lobes;
  const double relative = lattice / *std::max_element(radii.begin(), radii.end());
  for (const Eigen::Vector2d& sigma : lobe_sigma) {
    fit.sigma.lobes.push_back(
        {0.0, std::hypot(sigma.x(), relative), std::hypot(sigma.y(), relative), 0.0, 0.0});
  }
  std::vector<std::size_t> order(radii.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return radii[a] < radii[b]; });
  fit.material.ring_radii_mm.clear();
  fit.sigma.ring_radii_mm.clear();
  for (const std::size_t k : order) {
    fit.material.ring_radii_mm.push_back(radii[k]);
    fit.sigma.ring_radii_mm.push_back(std::hypot(radii_sigma[k], localised));
  }
}

void set_colours(Fit<Wood<>>& fit, const Surface& surface, const EndGrain& grain) {
  const auto [found, sigma] =
      ring_colours(surface, grain.wood, grain.shape.frame, fit.material.ring_radii_mm);
  fit.material.early_rgb = as_list(found.early);
  fit.material.late_rgb = as_list(found.late);
  fit.material.latewood_share = found.latewood_share;
  fit.material.latewood_onset = found.latewood_onset;
  fit.sigma.early_rgb = as_list(sigma.early);
  fit.sigma.late_rgb = as_list(sigma.late);
  fit.sigma.latewood_share = sigma.latewood_share;
  fit.sigma.latewood_onset = sigma.latewood_onset;
}

std::vector<std::string> remarks_on(const EndGrain& grain) {
  std::vector<std::string> remarks = {
      "An end grain does not show how fibres lean: spiral, wave and interlock keep their defaults; "
      "give the tangential face as well."};
  if (!grain.pith_inside) {
    remarks.push_back(
        "The pith lies outside the picture: ring radii count from where the rings seem to meet.");
  }
  const auto faint = std::count_if(grain.seen_share.begin(), grain.seen_share.end(),
                                   [](double share) { return share < well_seen; });
  if (faint > 0) {
    remarks.push_back(std::to_string(faint) +
                      " of the rings are seen in less than half of their course.");
  }
  return remarks;
}

}  // namespace

Fit<Wood<>> fit_wood(const Surface& surface) {
  const EndGrain grain = end_grain(surface);
  Fit<Wood<>> fit;
  fit.sigma = unknown();
  set_shape(fit, grain, surface.extent.pitch);
  set_colours(fit, surface, grain);
  fit.starts = fit.agreeing = 1;
  fit.remarks = remarks_on(grain);
  return fit;
}

}  // namespace hada
