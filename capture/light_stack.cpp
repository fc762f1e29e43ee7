#include "capture/light_stack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "capture/equalized.h"
#include "capture/sample_mask.h"
#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

void scale_strengths(std::vector<Light>& lights) {
  double sum = 0.0;
  for (const Light& light : lights) sum += light.strength.mean();
  for (Light& light : lights) light.strength *= double(lights.size()) / sum;
}

// What all pictures together show at each pixel, and which of its samples can be believed.
struct Levels {
  Grid<float> mean;
  std::vector<Grid<Sample>> samples;
};

// quantum  below it a sample is noise; below 3 % of the pixel's brightest it is shadow, filled only
//          by what the surroundings throw back
Levels levels_of(const Photographs& linear, const std::vector<Light>& lights, float quantum) {
  const std::size_t count = lights.size();
  const int rows = linear.camera.extent.rows;
  const int cols = linear.camera.extent.cols;
  Levels levels;
  levels.mean = Grid<float>(rows, cols);
  levels.samples.resize(count);
  for (auto& samples : levels.samples) {
    samples = Grid<Sample>(rows, cols, Sample::lit, linear.images.front().memory());
    samples.let_go();
  }
  const auto look_at_row = [&](int row) {
    const std::size_t begin = std::size_t(row) * std::size_t(cols);
    std::vector<float> greys(count);
    for (std::size_t i = begin; i < begin + std::size_t(cols); ++i) {
      float brightest = 0.0f;
      for (std::size_t k = 0; k < count; ++k) {
        greys[k] = equalized(linear.images[k], lights[k], i);
        levels.mean[i] += greys[k] / float(count);
        brightest = std::max(brightest, greys[k]);
      }
      const float dark = std::max(0.03f * brightest, quantum);
      for (std::size_t k = 0; k < count; ++k) {
        if (linear.saturated[k][i]) {
          levels.samples[k][i] = Sample::saturated;
        } else if (greys[k] <= dark) {
          levels.samples[k][i] = Sample::shadowed;
        }
      }
    }
  };
  for_slices(rows, [&](int first, int last) {
    for_each_band(first, last, [&](int begin, int end) {
      for (int row = begin; row < end; ++row) look_at_row(row);
      for (std::size_t k = 0; k < count; ++k) {
        linear.images[k].let_go(begin, end);
        linear.saturated[k].let_go(begin, end);
        levels.samples[k].let_go(begin, end);
      }
    });
  });
  return levels;
}

// For each picture the light that bears its name; empty if one finds none. `name` reads a name.
template <class Name>
std::vector<std::size_t> namesakes(const std::vector<Light>& lights, const CaptureFile& file,
                                   const Name& name) {
  std::vector<std::size_t> order;
  for (const auto& picture : file.pictures) {
    const auto same = std::find_if(lights.begin(), lights.end(), [&](const Light& light) {
      return name(light.image) == name(picture.name);
    });
    if (same == lights.end()) return {};
    const auto k = std::size_t(same - lights.begin());
    if (std::find(order.begin(), order.end(), k) != order.end()) return {};
    order.push_back(k);
  }
  return order;
}

// The light of each picture: the one of its name, else of its name without ending, else in order.
std::vector<std::size_t> matching(const std::vector<Light>& lights, const CaptureFile& file) {
  auto order = namesakes(lights, file, [](const std::string& name) { return name; });
  if (order.empty()) {
    order = namesakes(lights, file, [](const std::string& name) {
      return std::filesystem::path(name).replace_extension().string();
    });
  }
  if (!order.empty()) return order;
  if (lights.size() != file.pictures.size()) {
    throw Error(fmt::format(
        "{}: {} pictures, but {} lights are given; calibrate with the same set of lights",
        file.folder.string(), file.pictures.size(), lights.size()));
  }
  order.resize(lights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

}  // namespace

std::vector<Light> lights_in(const CaptureFile& file) {
  std::vector<Light> lights;
  for (const auto& picture : file.pictures) {
    if (!picture.direction) continue;
    Light light;
    light.image = picture.name;
    light.direction = *picture.direction;
    light.strength = picture.strength.value_or(Eigen::Vector3d::Ones());
    lights.push_back(light);
  }
  if (!lights.empty() && lights.size() < file.pictures.size()) {
    throw Error(fmt::format("{}: gives a light for {} of {} pictures; give one for each, or none",
                            (file.folder / "capture.json").string(), lights.size(),
                            file.pictures.size()));
  }
  return lights;
}

std::vector<Light> matched_lights(const std::vector<Light>& lights, const CaptureFile& file) {
  std::vector<Light> matched;
  for (const std::size_t k : matching(lights, file)) matched.push_back(lights[k]);
  for (std::size_t k = 0; k < matched.size(); ++k) matched[k].image = file.pictures[k].name;
  return matched;
}

LightsFile matched_lights(LightsFile lights, const Photographs& photographs) {
  const std::string folder = photographs.file.folder.string();
  const bool near = std::any_of(lights.lights.begin(), lights.lights.end(),
                                [](const Light& light) { return light.position.has_value(); });
  const Unit unit = photographs.camera.extent.unit;
  if (near && lights.position_unit == Unit::mm && unit == Unit::px) {
    throw Error(folder +
                ": lights have a position in mm, but nobody says how large a pixel is; give "
                "pitch_mm");
  }
  if (near && lights.position_unit == Unit::px && unit == Unit::mm) {
    throw Error(folder +
                ": lights have a position in px, found without a pitch, but these pictures have "
                "one; calibrate again with pitch_mm");
  }
  const auto order = matching(lights.lights, photographs.file);
  for (LightErrorMode& mode : lights.errors) {
    LightErrorMode matched;
    for (const std::size_t k : order) matched.push_back(mode[k]);
    mode = std::move(matched);
  }
  lights.lights = matched_lights(lights.lights, photographs.file);
  lights.highlights_px.clear();  // in pictures of another day
  return lights;
}

LightStack light_stack(Photographs photographs, std::vector<Light> lights,
                       const std::vector<Sphere>& spheres) {
  const std::string folder = photographs.file.folder.string();
  if (photographs.images.size() < 3) {
    throw Error(
        fmt::format("{}: {} picture{} given, at least 3 are needed, each lit from another side",
                    folder, photographs.images.size(), photographs.images.size() == 1 ? "" : "s"));
  }
  assert(lights.size() == photographs.images.size());
  scale_strengths(lights);
  const int bits = photographs.bits;
  photographs = linearized(std::move(photographs));

  constexpr float code_values = 2.0f;  // so many are noise
  const float quantum = bits <= 16 ? code_values / float((1 << bits) - 1) : 0.0f;
  Levels levels = levels_of(photographs, lights, quantum);

  LightStack stack;
  stack.camera = photographs.camera;
  stack.mask = photographs.mask.empty()
                   ? sample_mask(levels.mean, spheres, photographs.file.sample_box)
                   : photographs.mask;
  if (stack.mask.empty()) {
    throw Error(folder +
                ": no sample stands out from the background; give a mask or sample_box_px");
  }
  stack.samples = std::move(levels.samples);
  stack.images = std::move(photographs.images);
  stack.lights = std::move(lights);
  return stack;
}

}  // namespace hada
