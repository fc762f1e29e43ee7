#include "reconstruct/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/bounding_box.h"
#include "core/error.h"
#include "core/quantile.h"
#include "reconstruct/height_sigma.h"
#include "reconstruct/integrate.h"
#include "reconstruct/labels.h"
#include "reconstruct/remarks.h"

namespace hada {
namespace {

constexpr double least_slope = 0.05;  // mean; flatter, the surface hardly sees itself
constexpr int bounce_passes = 3;      // each leaves a third of the error of the one before
constexpr int near_passes = 2;

std::ptrdiff_t pixels_in(const Mask& mask) {
  return std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
}

// The part of the pictures that holds the sample, before its height is known.
Surface cropped(const Orientation& found, const Extent& extent) {
  const auto [row, col, rows, cols] = bounding_box(found.mask);
  Surface surface;
  surface.extent = {.rows = rows, .cols = cols, .pitch = extent.pitch, .unit = extent.unit};
  surface.mask = crop(found.mask, row, col, rows, cols);
  surface.normals = crop(found.normals, row, col, rows, cols);
  surface.albedo = crop(found.albedo, row, col, rows, cols);
  surface.normal_sigma = crop(found.normal_sigma, row, col, rows, cols);
  surface.offset_px = {col, row};
  return surface;
}

bool has_near_light(const LightStack& stack) {
  return std::any_of(stack.lights.begin(), stack.lights.end(),
                     [](const Light& light) { return light.position.has_value(); });
}

double mean_slope(const Orientation& found) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    if (!found.mask[i]) continue;
    const Eigen::Vector3f& n = found.normals[i];
    sum += std::hypot(n.x(), n.y()) / n.z();
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

Grid<float> albedo_inside(const Orientation& found) {
  Grid<float> rho = found.rho;
  for (std::size_t i = 0; i < rho.size(); ++i) {
    if (!found.mask[i]) rho[i] = 0.0f;
  }
  return rho;
}

// Normals, then the height that they give, then normals again that know of it: where near lights
// stand to each point, and what light the surface throws on itself. labels: if not null, found too
Orientation orientation_of(const LightStack& stack, Estimator estimator,
                           std::vector<Grid<Sample>>* labels) {
  NormalOptions options{.estimator = estimator, .uncertainty = false};
  const bool near = has_near_light(stack);
  const bool folded = estimator == Estimator::adaptive;
  Grid<float> height;
  Bounce bounce;
  double untold_bounce = 0.0;
  if (near || folded) {
    Orientation found = solve_normals(stack, options);
    const bool bounces = folded && mean_slope(found) > least_slope;
    const int passes = bounces ? bounce_passes : near ? near_passes : 0;
    for (int pass = 0; pass < passes; ++pass) {
      if (pass > 0) {
        found = {};  // large maps need not be there twice
        found = solve_normals(stack, options);
      }
      if (bounces && pass > 0 && found.terms.bounce == 0.0f) {  // nothing of it in the pictures
        options.bounce = nullptr;
        untold_bounce = found.untold_bounce;
        if (!near || pass >= near_passes) break;
      }
      if (std::count(found.mask.begin(), found.mask.end(), 1) == 0) break;
      height = integrate(found.normals, found.mask, stack.extent().pitch,
                         {.pin_hole = pin_hole_of(stack.camera, {0, 0})});
      if (near) options.height = &height;
      if (!bounces) continue;
      bounce = gather_bounce(stack, height, found.normals, albedo_inside(found));
      options.bounce = &bounce;
    }
  }
  options.uncertainty = true;
  Orientation found = solve_normals(stack, options);
  if (!options.bounce) found.untold_bounce = untold_bounce;
  if (labels) *labels = label_samples(stack, found, options);
  return found;
}

// How much the slope of each pixel counts: 1 over its variance, to which every pixel brings as much
// as is typical, since no sigma knows all that is wrong. Dark print under sheen then bends nothing
// but itself.
Grid<float> slope_weight(const Grid<float>& normal_sigma, const Mask& mask) {
  std::vector<float> sigmas;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) sigmas.push_back(normal_sigma[i]);
  }
  const float typical = std::max(median(std::move(sigmas)), 1e-9f);
  Grid<float> weight(mask.rows(), mask.cols(), 1.0f);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const float share = normal_sigma[i] / typical;
    if (mask[i]) weight[i] = 2.0f / (1.0f + share * share);
  }
  return weight;
}

}  // namespace

Reconstruction reconstruct(const LightStack& stack, const ReconstructOptions& options) {
  if (pixels_in(stack.mask) == 0) {
    throw Error("the mask is empty: no pixel belongs to the sample; check the mask or its box");
  }
  Reconstruction result;
  Orientation found =
      orientation_of(stack, options.estimator, options.labels ? &result.labels : nullptr);
  if (pixels_in(found.mask) == 0) {
    throw Error(
        "no pixel of the mask has three good samples and a normal towards the camera: check the "
        "lights, and whether the pictures are black or saturated");
  }

  result.estimator = options.estimator;
  result.noise = found.noise;
  result.relighting_error = found.relighting_error;
  result.left_out_error = found.left_out_error;
  result.light_errors = found.light_errors;
  const auto [row, col, rows, cols] = bounding_box(found.mask);
  result.inliers = crop(found.inliers, row, col, rows, cols);
  result.albedo_sigma = crop(found.albedo_sigma, row, col, rows, cols);
  for (auto& picture : result.labels) picture = crop(picture, row, col, rows, cols);
  result.condition = found.condition;
  result.remarks = remarks_on(stack, found);
  Surface& surface = result.surface;
  surface = cropped(found, stack.extent());
  found = {};  // the height needs the room of the uncropped maps
  const double pitch = surface.extent.pitch;
  surface.height = integrate(surface.normals, surface.mask, pitch,
                             {.weight = slope_weight(surface.normal_sigma, surface.mask),
                              .pin_hole = pin_hole_of(stack.camera, surface.offset_px)});
  std::optional<PriorHeights> prior;
  if (options.prior) {
    prior = {crop(options.prior->height, row, col, rows, cols), options.prior->cutoff_px};
    level(surface.height, surface.mask, *prior);
    surface.levelling = prior_levelling;
    surface.levelling_cutoff = prior->cutoff_px * pitch;
  } else {
    level(surface.height, surface.mask, options.levelling);
    surface.levelling = name_of(options.levelling);
  }
  surface.height_sigma = height_sigma(surface.normals, surface.normal_sigma, surface.mask, pitch,
                                      options.levelling, prior ? &*prior : nullptr);
  return result;
}

}  // namespace hada
