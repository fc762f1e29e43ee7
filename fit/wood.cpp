#include "fit/wood.h"

#include <algorithm>
#include <cmath>

#include "core/quantile.h"
#include "fit/ring_colours.h"
#include "fit/vessels.h"

namespace hada {
namespace {

// Interpolation and the lattice move all edges of a direction alike, which no scatter shows.
constexpr double lattice_px = 0.02;
constexpr double well_seen = 0.5;  // share of the sectors of a ring

/// A fit before anything is seen. Its sigma is that of fields that may be anything within their
/// bounds.
Fit<Wood<>> nothing_known() {
  Fit<Wood<>> fit;
  fit.starts = fit.agreeing = 1;
  Wood<>& sigma = fit.sigma;
  visit_fields(sigma, [](const std::string&, const auto& field, double& value) {
    value = (field.high - field.low) / std::sqrt(12.0);
  });
  sigma.cut_origin_mm = sigma.cut_right = sigma.cut_up = {0.0, 0.0, 0.0};  // the frame: by choice
  sigma.lobes.clear();
  return fit;
}

std::vector<double> as_list(const std::array<double, 3>& colour) {
  return {colour.begin(), colour.end()};
}

void set_shape(Fit<Wood<>>& fit, const EndGrain& grain, double pitch) {
  const GrowthFrame& frame = grain.shape.frame;
  const auto& radii = grain.shape.radii;
  const auto& radii_sigma = grain.shape.radii_sigma;
  const auto& pith_sigma = grain.shape.pith_sigma;
  const auto& lobe_sigma = grain.shape.lobe_sigma;
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
    fit.sigma.ring_radii_mm.push_back(std::hypot(radii_sigma[k], lattice));
  }
}

/// Moves radii from the middle of the rise to where the new ring begins.
void begin_rings(Fit<Wood<>>& fit, const RingRise& rise) {
  auto& radii = fit.material.ring_radii_mm;
  auto& sigma = fit.sigma.ring_radii_mm;
  const RingOnset onset = onset_of(rise, radii);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    radii[k] -= onset.before[k];
    sigma[k] = std::hypot(sigma[k], onset.sigma[k]);
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

/// Mean width of a ring, in the unit of the picture; 1 if none are known.
double usual_width(const std::vector<double>& radii) {
  return radii.size() < 2 ? 1.0 : (radii.back() - radii.front()) / double(radii.size() - 1);
}

void set_grain(Fit<Wood<>>& fit, const FaceGrain& grain) {
  fit.material.spiral = grain.gradient.value;
  fit.sigma.spiral = grain.gradient.sigma;
  if (grain.kind != FaceGrain::Kind::interlocked) {
    fit.material.wave_amplitude = grain.amplitude.value;
    fit.sigma.wave_amplitude = std::max(grain.amplitude.sigma, grain.gradient.sigma);
  }
  if (grain.kind != FaceGrain::Kind::wavy) {
    fit.material.interlock_amplitude = grain.amplitude.value;
    fit.sigma.interlock_amplitude = std::max(grain.amplitude.sigma, grain.gradient.sigma);
  }
  if (grain.kind == FaceGrain::Kind::wavy) {
    fit.material.wave_length_mm = grain.length.value;
    fit.sigma.wave_length_mm = grain.length.sigma;
    fit.material.wave_phase_rad = grain.phase.value;
    fit.sigma.wave_phase_rad = grain.phase.sigma;
  }
  if (grain.kind == FaceGrain::Kind::interlocked) {
    const double width = usual_width(fit.material.ring_radii_mm);
    fit.material.interlock_period = grain.length.value / width;
    fit.sigma.interlock_period = grain.length.sigma / width;
  }
}

/// A face alone: one colour, cut through the stem far from its pith.
void set_face(Fit<Wood<>>& fit, const Surface& surface) {
  constexpr double far_mm = 100.0;
  fit.material.ring_radii_mm.clear();
  fit.sigma.ring_radii_mm.clear();
  fit.sigma.lobes.assign(fit.material.lobes.size(), {0.0, 0.1, 0.1, 0.0, 0.0});
  fit.material.cut_origin_mm = {far_mm, 0.0, 0.0};
  fit.material.cut_right = {0.0, 1.0, 0.0};
  fit.material.cut_up = {0.0, 0.0, 1.0};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& plane = surface.albedo.planes[std::min(c, surface.albedo.planes.size() - 1)];
    std::vector<float> values;
    for (std::size_t i = 0; i < plane.size(); i += 7) {
      if (surface.mask[i]) values.push_back(plane[i]);
    }
    const double usual = values.empty() ? 0.5 : double(median(values));
    fit.material.early_rgb[c] = fit.material.late_rgb[c] = std::clamp(usual, 0.0, 1.0);
    fit.sigma.early_rgb[c] = fit.sigma.late_rgb[c] =
        values.empty() ? 0.3 : 0.5 * double(quantile(values, 0.84) - quantile(values, 0.16));
  }
}

std::vector<std::string> remarks_on(const FaceGrain& grain) {
  std::vector<std::string> remarks;
  if (grain.kind == FaceGrain::Kind::straight)
    remarks.push_back("The fibres of the face lean evenly: no wave or interlock can be told.");
  if (2 * grain.parts < grain.asked) {
    remarks.push_back("Fibres can be seen in " + std::to_string(grain.parts) + " of " +
                      std::to_string(grain.asked) + " parts of the face.");
  }
  return remarks;
}

std::vector<std::string> remarks_on(const EndGrain& grain) {
  std::vector<std::string> remarks;
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

void add(std::vector<std::string>& remarks, const std::vector<std::string>& more) {
  remarks.insert(remarks.end(), more.begin(), more.end());
}

void set_vessels(Fit<Wood<>>& fit, const std::optional<Vessels>& seen) {
  if (!seen) {
    fit.remarks.push_back(
        "No vessels of at least 4 px are seen: their density and size keep their defaults.");
    return;
  }
  Wood<>&wood = fit.material, &sigma = fit.sigma;
  wood.vessel_shade = seen->shade.value;
  sigma.vessel_shade = seen->shade.sigma;
  wood.vessel_density_per_mm2 = seen->density.value;
  sigma.vessel_density_per_mm2 = seen->density.sigma;
  wood.ring_vessels_per_mm = seen->ring_density.value;
  sigma.ring_vessels_per_mm = seen->ring_density.sigma;
  if (seen->porosity != Porosity::ring) {
    wood.vessel_radius_mm = seen->radius.value;
    sigma.vessel_radius_mm = seen->radius.sigma;
    wood.vessel_radius_sd_mm = seen->radius_sd;
    sigma.vessel_radius_sd_mm = seen->radius.sigma;
  }
  if (seen->porosity != Porosity::diffuse) {
    wood.ring_vessel_radius_mm = seen->ring_radius.value;
    sigma.ring_vessel_radius_mm = seen->ring_radius.sigma;
  }
  const char* kinds[] = {"diffuse-porous", "ring-porous", "ring-porous with vessels in between"};
  fit.remarks.push_back("The wood is " + std::string(kinds[int(seen->porosity)]) + ", by " +
                        std::to_string(seen->discs.size()) + " vessels, with a probability of " +
                        std::to_string(int(std::lround(100.0 * seen->probability))) + " %.");
}

}  // namespace

void add_face(Fit<Wood<>>& fit, const FaceGrain& grain) {
  set_grain(fit, grain);
  add(fit.remarks, remarks_on(grain));
}

Fit<Wood<>> wood_of(const EndGrain& grain, const Surface& surface) {
  Fit<Wood<>> fit = nothing_known();
  set_shape(fit, grain, surface.extent.pitch);
  set_colours(fit, surface, grain);
  fit.remarks = remarks_on(grain);
  set_vessels(fit, vessels_of(surface, grain));
  return fit;
}

Fit<Wood<>> fit_wood(const Surface& surface, const WoodFitOptions& options) {
  const bool is_face =
      options.view == WoodView::face ||
      (options.view == WoodView::automatic && !options.face && looks_like_a_face(surface));
  if (is_face) {
    const FaceGrain grain = face_grain(surface);
    Fit<Wood<>> fit = nothing_known();
    set_face(fit, surface);
    set_grain(fit, grain);
    fit.remarks = {
        "Taken for a face along the stem: it does not show pith or ring radii, and a flat "
        "patch cannot tell the distance of the pith from the width of the rings."};
    add(fit.remarks, remarks_on(grain));
    return fit;
  }
  const EndGrain grain = end_grain(surface);
  Fit<Wood<>> fit = wood_of(grain, surface);
  begin_rings(fit, grain.rise);
  if (options.face) {
    add_face(fit, face_grain(*options.face));
  } else {
    fit.remarks.insert(
        fit.remarks.begin(),
        "An end grain does not show how fibres lean: spiral, wave and interlock keep "
        "their defaults; give the tangential face as well.");
  }
  return fit;
}

}  // namespace hada
