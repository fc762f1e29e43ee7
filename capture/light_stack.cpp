#include "capture/light_stack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "capture/sample_mask.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

// A grey value with the light's strength divided out of each channel.
float equalized(const Image& image, const Light& light, std::size_t pixel) {
  if (image.channels() < 3) return float(image.planes[0][pixel] / light.strength[0]);
  float grey = 0.0f;
  for (int c = 0; c < 3; ++c) {
    grey += luminance_weight[c] * float(image.planes[std::size_t(c)][pixel] / light.strength[c]);
  }
  return grey;
}

void scale_strengths(std::vector<Light>& lights) {
  double sum = 0.0;
  for (const Light& light : lights) sum += light.strength.mean();
  for (Light& light : lights) light.strength *= double(lights.size()) / sum;
}

// The share of the brightness of bright pixels that no Lambertian surface under these lights shows.
double unexplained(const Photographs& photographs, const std::vector<Light>& lights,
                   bool as_linear) {
  Photographs read = copy_of(photographs);
  read.linear = as_linear;
  const Photographs linear = linearized(std::move(read));
  const std::size_t size = linear.images.front().planes.front().size();
  const std::size_t stride = std::max<std::size_t>(1, size / 20000);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < size; i += stride) {
    if (linear.mask.empty() || linear.mask[i]) chosen.push_back(i);
  }
  const auto count = Eigen::Index(lights.size());
  Eigen::MatrixX3d directions(count, 3);
  Eigen::MatrixXd all_values(count, Eigen::Index(chosen.size()));
  for (Eigen::Index k = 0; k < count; ++k) {
    const Image& image = linear.images[std::size_t(k)];
    const Light& light = lights[std::size_t(k)];
    directions.row(k) = light.direction;
    for (std::size_t p = 0; p < chosen.size(); ++p) {
      all_values(k, Eigen::Index(p)) = equalized(image, light, chosen[p]);
    }
    image.let_go();
  }
  const Eigen::MatrixXd inverse = directions.completeOrthogonalDecomposition().pseudoInverse();
  std::vector<std::pair<double, double>> pixels;  // brightness, residual
  for (Eigen::Index p = 0; p < all_values.cols(); ++p) {
    const Eigen::VectorXd values = all_values.col(p);
    const double residual = (values - directions * (inverse * values)).norm();
    pixels.emplace_back(values.norm(), residual);
  }
  if (pixels.empty()) return 0.0;
  std::sort(pixels.begin(), pixels.end());
  std::vector<double> shares;
  for (std::size_t i = pixels.size() / 2; i < pixels.size(); ++i) {
    shares.push_back(pixels[i].second / std::max(pixels[i].first, 1e-12));
  }
  return median(std::move(shares));
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

void settle_encoding(Photographs& photographs, const std::vector<Light>& lights) {
  if (photographs.encoding_known) return;
  if (lights.size() < 4) {
    photographs.remarks.push_back(
        "Too few pictures to tell how the 8-bit values are encoded; sRGB is assumed (say "
        "\"encoding\" in capture.json if it is not).");
    return;
  }
  const double linear = unexplained(photographs, lights, true);
  const double srgb = unexplained(photographs, lights, false);
  photographs.linear = linear <= srgb;
  photographs.encoding_known = true;
  photographs.remarks.push_back(fmt::format(
      "The 8-bit pictures are read as {}: that leaves {:.1f} % of the brightness unexplained, the "
      "other reading {:.1f} %.",
      photographs.linear ? "linear" : "sRGB", 100.0 * std::min(linear, srgb),
      100.0 * std::max(linear, srgb)));
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
