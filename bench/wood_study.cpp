#include "bench/wood_study.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numbers>
#include <vector>

#include "bench/made_stems.h"
#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/vessels.h"
#include "fit/wood.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Errors of the rings that were found, each true ring once.
struct Matched {
  std::vector<double> errors;
  std::vector<double> sigma;
};

Matched matched(const Wood<>& found, const Wood<>& sigma, const std::vector<double>& truth,
                double within) {
  Matched result;
  for (const double radius : truth) {
    std::size_t best = 0;
    const auto& radii = found.ring_radii_mm;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      if (std::abs(radii[k] - radius) < std::abs(radii[best] - radius)) best = k;
    }
    if (radii.empty() || std::abs(radii[best] - radius) > within) continue;
    result.errors.push_back(radii[best] - radius);
    result.sigma.push_back(sigma.ring_radii_mm[best]);
  }
  return result;
}

/// Radii that cross the picture; `all` adds those in a corner, which may or may not be found.
std::vector<double> visible(const Wood<>& wood, const Extent& extent, double clear_px) {
  double least = HUGE_VAL, most = 0.0;
  for (int row = 0; row < extent.rows; row += 2) {
    for (int col = 0; col < extent.cols; col += 2) {
      const Eigen::Vector2d arm =
          extent.place(row, col) - Eigen::Vector2d(wood.pith_mm[0], wood.pith_mm[1]);
      const double rho = effective_radius(wood.lobes, arm.norm(), std::atan2(arm.y(), arm.x()));
      least = std::min(least, rho);
      most = std::max(most, rho);
    }
  }
  if (least < 2.0 * extent.pitch) least = -HUGE_VAL;
  std::vector<double> radii;
  for (const double radius : wood.ring_radii_mm) {
    if (radius > least + clear_px * extent.pitch && radius < most - clear_px * extent.pitch)
      radii.push_back(radius);
  }
  return radii;
}

}  // namespace

BlockScore score_block(const std::filesystem::path& folder, const char* name) {
  const Json truths = Json::parse(std::ifstream(folder / "truth" / "truth.json"));
  const Json& truth = truths["blocks"][name];
  const double pitch = truth["pixel_mm_end"].get<double>();
  const auto end = read_surface(folder / name / "end_grain.png", pitch);
  const auto face =
      read_surface(folder / name / "tangential.png", truth["pixel_mm_tangential"].get<double>());
  const auto fit = fit_wood(end, {.view = WoodView::end_grain, .face = &face});
  const auto pith = truth["pith_mm"].get<std::vector<double>>();
  const auto radii = truth["visible_ring_radii_mm"].get<std::vector<double>>();
  const auto rings = matched(fit.material, fit.sigma, radii, 0.4);
  BlockScore score;
  score.pith_mm = std::hypot(fit.material.pith_mm[0] - pith[0], fit.material.pith_mm[1] - pith[1]);
  for (const double error : rings.errors)
    score.radii_mm += std::abs(error) / double(rings.errors.size());
  score.recall = double(rings.errors.size()) / double(radii.size());
  score.precision = double(rings.errors.size()) / double(fit.material.ring_radii_mm.size());
  score.spiral_deg =
      std::abs(std::atan(fit.material.spiral) / degree - truth["spiral_grain_deg"].get<double>());
  return score;
}

StemScore study_stems(int seeds) {
  const Extent extent{420, 460, 0.1, Unit::mm};
  std::vector<double> pith, radii, spiral, amplitude, length;
  Tally pith_tally, lobe_tally, radii_tally, gradient_tally, amplitude_tally, length_tally;
  double found = 0.0, asked = 0.0, given = 0.0;
  for (int k = 0; k < seeds; ++k) {
    const Seed seed = Seed(1000 + k);
    auto wood = made_stem(seed);
    const auto fit = fit_wood(picture_of(wood, extent, seed), {.view = WoodView::end_grain});
    const auto clear = visible(wood, extent, 8.0), all = visible(wood, extent, 0.0);
    const auto sure = matched(fit.material, fit.sigma, clear, 0.4);
    found += double(sure.errors.size());
    asked += double(clear.size());
    given += double(fit.material.ring_radii_mm.size() + clear.size()) -
             double(matched(fit.material, fit.sigma, all, 0.4).errors.size());
    for (std::size_t i = 0; i < sure.errors.size(); ++i) {
      radii.push_back(sure.errors[i] * sure.errors[i] / (extent.pitch * extent.pitch));
      radii_tally.add(sure.errors[i], sure.sigma[i]);
    }
    const Eigen::Vector2d off(fit.material.pith_mm[0] - wood.pith_mm[0],
                              fit.material.pith_mm[1] - wood.pith_mm[1]);
    pith.push_back(off.norm() / all.back());
    for (std::size_t i = 0; i < 2; ++i) {
      pith_tally.add(off[Eigen::Index(i)], fit.sigma.pith_mm[i]);
      lobe_tally.add(fit.material.lobes[i].cosine - wood.lobes[i].cosine,
                     fit.sigma.lobes[i].cosine);
      lobe_tally.add(fit.material.lobes[i].sine - wood.lobes[i].sine, fit.sigma.lobes[i].sine);
    }

    wood.cut_origin_mm = {90.0, 0.0, 0.0};  // so far out that the face is flat to the rings
    wood.cut_right = {0.0, 1.0, 0.0};
    wood.cut_up = {0.0, 0.0, 1.0};
    wood.fibre_shift = 0.25;
    wood.spiral = -0.2 + 0.4 * uniform(seed, 10);
    wood.wave_amplitude = 0.08 + 0.12 * uniform(seed, 11);
    wood.wave_length_mm = 13.0 + 7.0 * uniform(seed, 12);
    const auto lean =
        fit_wood(picture_of(wood, {600, 300, 0.1, Unit::mm}, seed + 1), {.view = WoodView::face});
    spiral.push_back(std::abs(lean.material.spiral - wood.spiral));
    amplitude.push_back(std::abs(lean.material.wave_amplitude / wood.wave_amplitude - 1.0));
    length.push_back(std::abs(lean.material.wave_length_mm / wood.wave_length_mm - 1.0));
    gradient_tally.add(lean.material.spiral - wood.spiral, lean.sigma.spiral);
    amplitude_tally.add(lean.material.wave_amplitude - wood.wave_amplitude,
                        lean.sigma.wave_amplitude);
    length_tally.add(lean.material.wave_length_mm - wood.wave_length_mm, lean.sigma.wave_length_mm);
  }
  StemScore score;
  score.pith_share = median(pith);
  double sum = 0.0;
  for (const double square : radii) sum += square / double(radii.size());
  score.radii_px = std::sqrt(sum);
  const double recall = found / asked, precision = asked / given;
  score.f1 = 2.0 * recall * precision / (recall + precision);
  score.pith_coverage = pith_tally.share();
  score.lobe_coverage = lobe_tally.share();
  score.radii_coverage = radii_tally.share();
  for (const Tally* part : {&pith_tally, &lobe_tally}) radii_tally.add(*part);
  score.coverage = radii_tally.share();
  score.spiral = median(spiral);
  score.wave_amplitude = median(amplitude);
  score.wave_length = median(length);
  score.gradient_coverage = gradient_tally.share();
  score.amplitude_coverage = amplitude_tally.share();
  score.length_coverage = length_tally.share();
  for (const Tally* part : {&amplitude_tally, &length_tally}) gradient_tally.add(*part);
  score.face_coverage = gradient_tally.share();
  return score;
}

InterlockScore study_interlock(int seeds) {
  const Extent extent{300, 900, 0.1, Unit::mm};
  constexpr double far_mm = 2500.0;  // so that rings run nearly straight over the face
  InterlockScore score;
  std::vector<double> errors;
  Tally tally;
  for (int k = 0; k < seeds; ++k) {
    const Seed seed = Seed(5000 + k);
    auto wood = made_stem(seed);
    const double width = 1.6 + 1.2 * uniform(seed, 30), slant = 0.4 + 0.2 * uniform(seed, 31);
    wood.pith_mm = {0.0, 0.0};
    wood.lobes.clear();
    wood.ring_radii_mm.clear();
    for (double radius = width; radius < far_mm + 100.0; radius += width)
      wood.ring_radii_mm.push_back(radius);
    wood.interlock_amplitude = 0.1 + 0.1 * uniform(seed, 32);
    wood.interlock_period = (10.0 + 6.0 * uniform(seed, 33)) / width;
    wood.interlock_phase_rad = 6.28 * uniform(seed, 34);
    wood.fibre_shift = 0.25;
    wood.cut_origin_mm = {far_mm, 0.0, 0.0};
    wood.cut_right = {slant, 1.0, 0.0};
    wood.cut_up = {0.0, 0.0, 1.0};
    const auto fit = fit_wood(picture_of(wood, extent, seed), {.view = WoodView::face});
    ++score.faces;
    if (!(fit.material.interlock_amplitude > 0.0)) continue;
    ++score.told;
    // A face alone gives the period along it, mm.
    const double rings = slant / std::hypot(slant, 1.0) / width;
    const double error = fit.material.interlock_period * rings - wood.interlock_period;
    errors.push_back(std::abs(error) / wood.interlock_period);
    tally.add(error, fit.sigma.interlock_period * rings);
  }
  score.period = errors.empty() ? HUGE_VAL : median(errors);
  score.coverage = tally.share();
  return score;
}

VesselScore study_vessels(int seeds) {
  const Extent extent{1000, 1000, 0.025, Unit::mm};
  VesselScore score;
  std::vector<double> density, radius;
  Tally tally;
  for (int k = 0; k < seeds; ++k) {
    const Seed seed = Seed(3000 + k);
    auto wood = made_stem(seed);
    wood.pith_mm = {-9.0 - 6.0 * uniform(seed, 20), 4.0 * uniform(seed, 21)};
    const bool ring = k % 2 == 1;
    if (ring) {
      wood.ring_vessels_per_mm = 0.7 + 0.5 * uniform(seed, 22);
      wood.ring_vessel_radius_mm = 0.13 + 0.06 * uniform(seed, 23);
    } else {
      wood.vessel_density_per_mm2 = 1.0 + 1.5 * uniform(seed, 22);
      wood.vessel_radius_mm = 0.11 + 0.05 * uniform(seed, 23);
      wood.vessel_radius_sd_mm = 0.01;
    }
    const auto surface = picture_of(wood, extent, seed, 2);
    const auto seen = vessels_of(surface, end_grain(surface));
    ++score.woods;
    if (!seen) continue;
    if (seen->porosity == (ring ? Porosity::ring : Porosity::diffuse)) ++score.right;
    const Known& many = ring ? seen->ring_density : seen->density;
    const Known& large = ring ? seen->ring_radius : seen->radius;
    const double true_many = ring ? wood.ring_vessels_per_mm : wood.vessel_density_per_mm2;
    const double true_large = ring ? wood.ring_vessel_radius_mm : wood.vessel_radius_mm;
    density.push_back(std::abs(many.value / true_many - 1.0));
    radius.push_back(std::abs(large.value / true_large - 1.0));
    tally.add(many.value - true_many, many.sigma);
    tally.add(large.value - true_large, large.sigma);
  }
  score.density = density.empty() ? HUGE_VAL : median(density);
  score.radius = radius.empty() ? HUGE_VAL : median(radius);
  score.coverage = tally.share();
  return score;
}

double seconds_of_a_slice() {
  Wood<> wood = made_stem(1);
  wood.cut_origin_mm = {20.0, 0.0, 0.0};
  wood.cut_right = {0.0, 1.0, 0.0};
  wood.cut_up = {0.0, 0.0, 1.0};
  wood.wave_amplitude = 0.15;
  wood.wave_length_mm = 20.0;
  wood.ring_vessels_per_mm = 1.5;
  const int before = threads();
  set_threads(1);
  const std::clock_t start = std::clock();
  synthesize(wood, {2048, 2048, 0.03, Unit::mm}, 1);
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  set_threads(before);
  return seconds;
}

}  // namespace hada
