#include "app/prior_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/surface_file.h"

namespace hada {
namespace {

constexpr double most_stretch = 1.02;  // of one side against the other
constexpr double least_cutoff_px = 4.0;

constexpr double same_pitch = 1e-3;  // up to this share

// Which pixel of a surface shows what a pixel of the pictures does, along rows or columns.
struct Scale {
  double first = 0.0;  // of the pictures, that the surface shows
  double per_pixel = 1.0;

  double at(int pixel) const { return (pixel + 0.5 - first) * per_pixel - 0.5; }
};

struct Placement {
  Scale row, col;
};

Placement placement_of(const Surface& known, bool is_map, const Extent& frame,
                       const std::string& name) {
  const auto [rows, cols, pitch, unit] = known.extent;
  const Eigen::Vector2i& offset = known.offset_px;
  const bool fits = offset.y() + rows <= frame.rows && offset.x() + cols <= frame.cols;
  if (!is_map && fits && std::abs(pitch - frame.pitch) < same_pitch * frame.pitch) {
    return {{double(offset.y()), 1.0}, {double(offset.x()), 1.0}};
  }
  const double down = double(rows) / frame.rows;
  const double right = double(cols) / frame.cols;
  if (std::max(down, right) > most_stretch * std::min(down, right)) {
    throw Error(fmt::format(
        "{}: is {} x {} pixels, the pictures {} x {}: they cannot show the same; cut it to what "
        "the pictures show",
        name, cols, rows, frame.cols, frame.rows));
  }
  return {{0.0, down}, {0.0, right}};
}

// Linear between the pixels of a surface, the outermost ones going on for half a pixel; not a
// number beyond, and where a pixel is outside its mask.
float height_at(const Surface& surface, double row, double col) {
  const Extent& extent = surface.extent;
  if (!(row >= -0.5 && row <= extent.rows - 0.5 && col >= -0.5 && col <= extent.cols - 0.5)) {
    return std::nanf("");
  }
  const double r = std::clamp(row, 0.0, extent.rows - 1.0);
  const double c = std::clamp(col, 0.0, extent.cols - 1.0);
  double sum = 0.0;
  for (const int down : {0, 1}) {
    for (const int right : {0, 1}) {
      const double share =
          (down ? r - int(r) : 1.0 - (r - int(r))) * (right ? c - int(c) : 1.0 - (c - int(c)));
      if (share == 0.0) continue;
      if (!surface.mask(int(r) + down, int(c) + right)) return std::nanf("");
      sum += share * surface.height(int(r) + down, int(c) + right);
    }
  }
  return float(sum);
}

}  // namespace

PriorHeights read_prior(const PriorArguments& arguments, const Extent& frame,
                        const PixelBox& part) {
  const std::string name = arguments.file->string();
  // A folder says its own unit, a height map that of the surface.
  const bool is_map = !std::filesystem::is_directory(*arguments.file);
  const Surface known = read_surface(*arguments.file, is_map && frame.unit == Unit::mm
                                                          ? std::optional<double>(frame.pitch)
                                                          : std::nullopt);
  if (!known.has_height()) {
    throw Error(name + ": holds no height; give a surface folder or a height map in floats");
  }
  if (known.extent.unit != frame.unit) {
    throw Error(fmt::format("{}: has its heights in {}, but the surface is in {}; give --pitch",
                            name, name_of(known.extent.unit), name_of(frame.unit)));
  }
  const Placement placement = placement_of(known, is_map, frame, name);
  PriorHeights prior{Grid<float>(part.rows, part.cols)};
  prior.cutoff_px = arguments.cutoff
                        ? *arguments.cutoff / frame.pitch
                        : std::max(0.25 * std::min(part.rows, part.cols), least_cutoff_px);
  if (!(prior.cutoff_px >= least_cutoff_px)) {
    throw Error(fmt::format(
        "--cutoff {:.4g}: is less than four pixels; give a wavelength of {:.4g} {} or more",
        *arguments.cutoff, least_cutoff_px * frame.pitch, name_of(frame.unit)));
  }
  for_each_index(part.rows, [&](int row) {
    for (int col = 0; col < part.cols; ++col) {
      prior.height(row, col) =
          height_at(known, placement.row.at(part.row + row), placement.col.at(part.col + col));
    }
  });
  return prior;
}

}  // namespace hada
