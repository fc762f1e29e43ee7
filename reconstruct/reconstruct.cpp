#include "reconstruct/reconstruct.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "core/bounding_box.h"
#include "core/error.h"
#include "reconstruct/height_sigma.h"
#include "reconstruct/integrate.h"
#include "reconstruct/regions.h"

namespace hada {
namespace {

// Where a person should hear of it.
constexpr double poor_condition = 8.0;    // noise reaches the worst axis eight times as strong
constexpr double poor_share_lost = 0.02;  // of the pixels of the mask
constexpr double poor_relighting_error = 0.10;  // a tenth of the picture is not explained
constexpr std::size_t few_lights = 6;           // fewer, and one sheen or shadow decides a normal
constexpr double notable_region = 0.01;         // of the pixels of the mask

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

std::string percent(double share) {
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.1 ? 1 : 0);
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
  if (found.relighting_error > poor_relighting_error) {
    remarks.push_back(
        fmt::format("A matte surface under these lights explains the pictures only up to {}: look "
                    "for sheen, shadows, or pictures that are not linear.",
                    percent(found.relighting_error)));
  }
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

}  // namespace

Reconstruction reconstruct(const LightStack& stack, const ReconstructOptions& options) {
  if (pixels_in(stack.mask) == 0) {
    throw Error("the mask is empty: no pixel belongs to the sample; check the mask or its box");
  }
  const Orientation found = least_squares_normals(stack, options.estimator);
  if (pixels_in(found.mask) == 0) {
    throw Error(
        "no pixel of the mask has three good samples and a normal towards the camera: check the "
        "lights, and whether the pictures are black or saturated");
  }

  Reconstruction result;
  Surface& surface = result.surface;
  surface = cropped(found, stack.extent());
  const double pitch = surface.extent.pitch;
  surface.height = integrate(surface.normals, surface.mask, pitch,
                             {.pin_hole = pin_hole_of(stack.camera, surface.offset_px)});
  level(surface.height, surface.mask, options.levelling);
  surface.levelling = name_of(options.levelling);
  surface.height_sigma =
      height_sigma(surface.normals, surface.normal_sigma, surface.mask, pitch, options.levelling);
  result.estimator = options.estimator;
  result.noise = found.noise;
  result.relighting_error = found.relighting_error;
  result.condition = found.condition;
  result.remarks = remarks_on(stack, found);
  return result;
}

}  // namespace hada
