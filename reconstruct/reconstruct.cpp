#include "reconstruct/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/bounding_box.h"
#include "core/error.h"
#include "core/quantile.h"
#include "reconstruct/height_sigma.h"
#include "reconstruct/integrate.h"
#include "reconstruct/regions.h"

namespace hada {
namespace {

// Where a person should hear of it.
constexpr double poor_condition = 8.0;    // noise reaches the worst axis eight times as strong
constexpr double poor_share_lost = 0.02;  // of the pixels of the mask
constexpr double poor_relighting_error = 0.10;  // a tenth of the picture is not explained
constexpr int few_inliers = 5;                  // two more than the unknowns
constexpr double odd_light = 3.0;               // times the typical error
constexpr std::size_t few_lights = 6;           // fewer, and one sheen or shadow decides a normal
constexpr double notable_turn = 0.003;          // rad, of normals by light that is not told
constexpr double least_slope = 0.05;            // mean; flatter, the surface hardly sees itself
constexpr int bounce_passes = 3;  // each leaves a third of the error of the one before
constexpr int near_passes = 2;
constexpr double notable_region = 0.01;  // of the pixels of the mask

std::ptrdiff_t pixels_in(const Mask& mask) {
  return std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
}

double mean_albedo(const Orientation& found) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    if (!found.mask[i]) continue;
    sum += double(found.rho[i]);
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
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

std::string percent(double share) {
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.1 ? 1 : 0);
}

void remark_on_inliers(const Orientation& found, std::size_t lights,
                       std::vector<std::string>& remarks) {
  if (lights < few_lights) return;
  double few = 0.0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    few += found.mask[i] && found.inliers[i] < few_inliers;
  }
  const double share = few / double(std::max<std::ptrdiff_t>(1, pixels_in(found.mask)));
  if (share <= poor_share_lost) return;
  remarks.push_back(fmt::format(
      "At {} of the pixels fewer than {} samples agree, so one more that is wrong would turn the "
      "normal; more lights, or higher ones where shadows fall, would help.",
      percent(share), few_inliers));
}

// A light that the others contradict much more than they contradict each other.
void remark_on_lights(const LightStack& stack, const Orientation& found,
                      std::vector<std::string>& remarks) {
  if (found.light_errors.size() < few_lights) return;
  const double typical = median(found.light_errors);
  for (std::size_t k = 0; k < found.light_errors.size(); ++k) {
    const double error = found.light_errors[k];
    if (error < odd_light * typical || error < poor_relighting_error) continue;
    remarks.push_back(fmt::format(
        "The picture of light {} is off by {} from what the others predict (typical: {}); check "
        "that light, or leave the picture out.",
        stack.lights[k].image, percent(error), percent(typical)));
  }
}

void remark_on_terms(const Orientation& found, std::vector<std::string>& remarks) {
  const SharedTerms& terms = found.terms;
  if (terms.curved()) {
    const auto departure = [&](float u) {
      return u * (terms.curve[0] + u * (terms.curve[1] + u * terms.curve[2]));
    };
    remarks.push_back(fmt::format(
        "The surface is not quite matte: at 45 and at 70 degrees from the light it sends {:+.0f} % "
        "and {:+.0f} % of what Lambert's law says. One curve for all pixels was taken into "
        "account.",
        100.0f * departure(0.293f), 100.0f * departure(0.658f)));
  }
  if (terms.bounce > 0.0f) {
    remarks.push_back(fmt::format(
        "Light that the surface throws on itself was taken off; it is as strong as an albedo of "
        "{:.2f} would send.",
        double(terms.bounce) * mean_albedo(found)));
  } else if (found.untold_bounce > notable_turn) {
    remarks.push_back(fmt::format(
        "Light that folds throw on each other cannot be told from their shape in these pictures. "
        "If the surface sends half of it back, the normals are off by about {:.1f} deg, which "
        "their uncertainties do not know of; lower lights, whose shadows reach into the folds, "
        "would tell.",
        found.untold_bounce * 180.0 / std::numbers::pi));
  }
}

std::vector<std::string> remarks_on(const LightStack& stack, const Orientation& found) {
  std::vector<std::string> remarks;
  const std::size_t lights = stack.lights.size();
  if (lights == 3) {
    remarks.push_back(
        fmt::format("With three lights nothing is left over to judge the noise by; the "
                    "uncertainties assume {} of the largest value. More lights would tell.",
                    found.noise));
  } else if (lights < few_lights) {
    remarks.push_back(
        fmt::format("There are only {} lights, so shadow and sheen can hardly be told from shape; "
                    "{} or more are better.",
                    lights, few_lights));
  }
  if (found.condition > poor_condition) {
    remarks.push_back(fmt::format(
        "The lights lie close to one plane (condition {:.1f}, 1 is ideal), so noise is "
        "strong in one direction; spread them around the sample, 30 to 60 degrees above "
        "the table.",
        found.condition));
  }
  const double lost = 1.0 - double(pixels_in(found.mask)) / double(pixels_in(stack.mask));
  if (lost > poor_share_lost) {
    remarks.push_back(fmt::format(
        "{} of the pixels of the mask have no normal: fewer than three good samples, "
        "or a normal that looks away. More lights, or a shorter exposure where pictures "
        "are saturated, would help.",
        percent(lost)));
  }
  if (found.left_out_error > poor_relighting_error) {
    remarks.push_back(
        fmt::format("A matte surface under these lights explains the pictures only up to {}: look "
                    "for sheen, shadows, or pictures that are not linear. Samples that do not fit "
                    "were left out where the estimator can.",
                    percent(found.left_out_error)));
  }
  remark_on_inliers(found, lights, remarks);
  remark_on_lights(stack, found, remarks);
  remark_on_terms(found, remarks);
  const Regions regions = regions_of(found.mask);
  const auto notable = std::count_if(regions.size.begin() + 1, regions.size.end(), [&](int size) {
    return size > notable_region * double(pixels_in(found.mask));
  });
  if (notable > 1) {
    remarks.push_back(fmt::format(
        "The mask has {} separate regions; how high they lie above one another is not known.",
        notable));
  }
  return remarks;
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
// stand to each point, and what light the surface throws on itself.
Orientation orientation_of(const LightStack& stack, Estimator estimator) {
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
  Orientation found = orientation_of(stack, options.estimator);
  if (pixels_in(found.mask) == 0) {
    throw Error(
        "no pixel of the mask has three good samples and a normal towards the camera: check the "
        "lights, and whether the pictures are black or saturated");
  }

  Reconstruction result;
  result.estimator = options.estimator;
  result.noise = found.noise;
  result.relighting_error = found.relighting_error;
  result.left_out_error = found.left_out_error;
  result.light_errors = found.light_errors;
  const auto [row, col, rows, cols] = bounding_box(found.mask);
  result.inliers = crop(found.inliers, row, col, rows, cols);
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
