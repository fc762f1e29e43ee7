#include "capture/load.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/image_file.h"

namespace hada {
namespace {

void check_values(const std::string& name, const ImageFile& file) {
  float lowest = HUGE_VALF;
  float highest = -HUGE_VALF;
  for (const auto& plane : file.image.planes) {
    for (const float value : plane) {
      if (!std::isfinite(value)) {
        throw Error(name + ": holds values that are not numbers; export the picture again");
      }
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  // One code value above zero is what a covered lens gives.
  const float black = file.floating ? 0.0f : 1.5f / float((1 << std::min(file.bits, 16)) - 1);
  if (highest <= black) {
    throw Error(name + ": is all black; check the exposure or leave the picture out");
  }
  if (!file.floating && lowest >= 1.0f) {
    throw Error(name + ": is all white; expose less or leave the picture out");
  }
}

Mask saturated_pixels(const ImageFile& file, std::pmr::memory_resource* memory) {
  Mask saturated(file.image.rows(), file.image.cols(), 0, memory);
  if (file.floating) return saturated;  // a float file has no largest value
  const float full = 1.0f - 0.5f / float((1 << std::min(file.bits, 16)) - 1);
  for (const auto& plane : file.image.planes) {
    for (std::size_t i = 0; i < plane.size(); ++i) saturated[i] |= plane[i] >= full;
  }
  saturated.let_go();
  return saturated;
}

std::size_t bytes_of(const Image& image) {
  return std::size_t(image.channels()) * image.planes.front().size() * sizeof(float);
}

Image kept(Image image, std::pmr::memory_resource* memory) {
  if (image.memory() == memory) return image;
  Image copy;
  for (Grid<float>& plane : image.planes) {
    copy.planes.emplace_back(plane.rows(), plane.cols(), 0.0f, memory);
    std::copy(plane.begin(), plane.end(), copy.planes.back().begin());
    copy.planes.back().let_go();
    plane = {};
  }
  return copy;
}

std::string size_text(const Image& image) {
  return fmt::format("{} x {} with {} channel{}", image.cols(), image.rows(), image.channels(),
                     image.channels() == 1 ? "" : "s");
}

// An auxiliary picture (mask, dark, ambient, flat) of the same size as the others.
Image companion(const std::filesystem::path& path, const Camera& camera) {
  Image image = read_image(path).image;
  if (image.rows() != camera.extent.rows || image.cols() != camera.extent.cols) {
    throw Error(fmt::format("{}: is {}, but the pictures are {} x {}; use one size", path.string(),
                            size_text(image), camera.extent.cols, camera.extent.rows));
  }
  return image;
}

Mask mask_from(const std::filesystem::path& path, const Camera& camera) {
  const Grid<float> grey = luminance(companion(path, camera));
  Mask mask(grey.rows(), grey.cols());
  std::transform(grey.begin(), grey.end(), mask.begin(), [](float g) { return g > 0.5f; });
  if (std::none_of(mask.begin(), mask.end(), [](auto m) { return m != 0; })) {
    throw Error(path.string() + ": no pixel of the mask is white; paint the sample white");
  }
  return mask;
}

Camera camera_of(const CaptureFile& file, const Image& first) {
  Camera camera;
  camera.extent = {first.rows(), first.cols(), file.pitch_mm.value_or(1.0),
                   file.pitch_mm ? Unit::mm : Unit::px};
  if (!file.camera || !file.camera->perspective) return camera;
  camera.model = Camera::Model::perspective;
  if (file.camera->focal_px) {
    camera.focal_px = *file.camera->focal_px;
  } else if (file.camera->distance_mm && file.pitch_mm) {
    camera.focal_px = *file.camera->distance_mm / *file.pitch_mm;
  } else {
    throw Error((file.folder / "capture.json").string() +
                ": a perspective camera needs focal_px, or distance_mm and pitch_mm");
  }
  return camera;
}

void decode_srgb(Grid<float>& plane) {
  for (float& value : plane) value = linear_from_srgb(value);
}

// The plane that belongs to channel `c`; a grey companion serves every channel.
const Grid<float>& plane_for(int c, const Image& companion) {
  return companion.planes[std::size_t(std::min(c, companion.channels() - 1))];
}

void subtract(Grid<float>& plane, const Grid<float>& minus) {
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] -= minus[i];
}

void subtract(Grid<float>& plane, float value) {
  for (float& each : plane) each -= value;
}

// Divides by the flat field, scaled to a mean of 1 so that exposure keeps its meaning.
void divide_by_flat(Grid<float>& plane, const Grid<float>& by) {
  double sum = 0.0;
  for (const float value : by) sum += value;
  const double mean = sum / double(by.size());
  // Where the flat field is nearly black the quotient would be noise: leave such pixels dark.
  const float least = float(0.02 * mean);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    plane[i] = by[i] > least ? float(plane[i] * mean / by[i]) : 0.0f;
  }
}

// Divides by what the lens leaves of the light, see `CaptureFile`.
void undo_vignetting(Grid<float>& plane, const std::array<double, 3>& k) {
  const double middle_row = 0.5 * (plane.rows() - 1), middle_col = 0.5 * (plane.cols() - 1);
  const double corner =
      0.25 * (double(plane.rows()) * plane.rows() + double(plane.cols()) * plane.cols());
  for (int row = 0; row < plane.rows(); ++row) {
    for (int col = 0; col < plane.cols(); ++col) {
      const double down = row - middle_row, right = col - middle_col;
      const double square = (down * down + right * right) / corner;
      const double left = 1.0 + square * (k[0] + square * (k[1] + square * k[2]));
      plane(row, col) = float(plane(row, col) / left);
    }
  }
}

}  // namespace

Photographs load_photographs(const CaptureFile& file, const LoadOptions& options) {
  if (file.pictures.empty()) {
    throw Error(file.folder.string() + ": holds no pictures; put one picture per light there");
  }
  Photographs photographs;
  photographs.file = file;
  const std::size_t count = file.pictures.size();
  photographs.bits = 32;
  bool all_deep = true;
  for (std::size_t k = 0; k < count; ++k) {
    ImageFile read = read_image(file.pictures[k].file);
    check_values(file.pictures[k].file.string(), read);
    const Image& first = k == 0 ? read.image : photographs.images.front();
    if (read.image.rows() != first.rows() || read.image.cols() != first.cols() ||
        read.image.channels() != first.channels()) {
      throw Error(fmt::format("{}: is {}, but {} is {}; all pictures must be of one size",
                              file.pictures[k].file.string(), size_text(read.image),
                              file.pictures[0].name, size_text(first)));
    }
    photographs.bits = std::min(photographs.bits, read.bits);
    all_deep = all_deep && (read.floating || read.bits > 8);
    std::pmr::memory_resource* const memory =
        options.memory.value_or(memory_for_pictures(count * bytes_of(read.image)));
    photographs.saturated.push_back(saturated_pixels(read, memory));
    photographs.images.push_back(kept(std::move(read.image), memory));
  }
  const Image& first = photographs.images.front();
  constexpr int smallest_side = 16;  // a sphere and a sample cannot share fewer pixels
  if (std::min(first.rows(), first.cols()) < smallest_side) {
    throw Error(fmt::format("{}: is only {} pixels; a sample needs at least {} x {}",
                            file.pictures[0].file.string(), size_text(first), smallest_side,
                            smallest_side));
  }
  photographs.camera = camera_of(file, first);
  // 8-bit files nearly always carry the sRGB curve, deeper ones nearly never do.
  photographs.linear = file.encoding == "linear" || (file.encoding == "auto" && all_deep);
  photographs.encoding_known = file.encoding != "auto" || all_deep;
  if (file.mask) photographs.mask = mask_from(*file.mask, photographs.camera);
  for (const auto& name : file.left_out) photographs.remarks.push_back("Left out: " + name + ".");
  return photographs;
}

bool has_vignetting(const CaptureFile& file) {
  return file.vignetting != std::array<double, 3>{};
}

bool is_linearized(const Photographs& photographs) {
  const CaptureFile& file = photographs.file;
  return photographs.linear && !file.dark && !file.ambient && !file.flat && !has_vignetting(file) &&
         photographs.ambient_light.isZero();
}

Photographs linearized(Photographs photographs) {
  if (is_linearized(photographs)) {
    photographs.encoding_known = true;
    return photographs;
  }
  const CaptureFile& file = photographs.file;
  const auto read_linear = [&](const std::optional<std::filesystem::path>& path) {
    std::optional<Image> image;
    if (path) image = companion(*path, photographs.camera);
    if (!image || photographs.linear) return image;
    for (auto& plane : image->planes) decode_srgb(plane);
    return image;
  };
  const auto dark = read_linear(file.dark);
  auto ambient = read_linear(file.ambient);
  auto flat = read_linear(file.flat);
  if (flat && dark) {
    for (int c = 0; c < flat->channels(); ++c) {
      subtract(flat->planes[std::size_t(c)], plane_for(c, *dark));
    }
  }
  // The ambient frame holds the dark signal too: subtracting it removes both.
  const Image* const background = ambient ? &*ambient : dark ? &*dark : nullptr;
  for_each_index(int(photographs.images.size()), [&](int k) {
    Image& image = photographs.images[std::size_t(k)];
    for (int c = 0; c < image.channels(); ++c) {
      Grid<float>& plane = image.planes[std::size_t(c)];
      if (!photographs.linear) decode_srgb(plane);
      if (background) subtract(plane, plane_for(c, *background));
      if (flat) divide_by_flat(plane, plane_for(c, *flat));
      if (has_vignetting(file)) undo_vignetting(plane, file.vignetting);
      subtract(plane, float(photographs.ambient_light[c]));
      plane.let_go();
    }
  });
  photographs.linear = true;
  photographs.encoding_known = true;
  photographs.file.dark.reset();
  photographs.file.ambient.reset();
  photographs.file.flat.reset();
  photographs.file.vignetting = {};
  photographs.ambient_light.setZero();
  return photographs;
}

Photographs copy_of(const Photographs& photographs) {
  Photographs copy = without_pictures(photographs);
  for (const Image& image : photographs.images) {
    copy.images.emplace_back();
    for (const auto& plane : image.planes) {
      copy.images.back().planes.push_back(plane);
      plane.let_go();
      copy.images.back().let_go();
    }
  }
  for (const Mask& saturated : photographs.saturated) {
    copy.saturated.push_back(saturated);
    saturated.let_go();
    copy.saturated.back().let_go();
  }
  return copy;
}

Photographs without_pictures(const Photographs& photographs) {
  return {.file = photographs.file,
          .camera = photographs.camera,
          .images = {},
          .saturated = {},
          .mask = photographs.mask,
          .bits = photographs.bits,
          .linear = photographs.linear,
          .encoding_known = photographs.encoding_known,
          .ambient_light = photographs.ambient_light,
          .remarks = photographs.remarks};
}

}  // namespace hada
