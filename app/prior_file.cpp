#include "app/prior_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/surface_file.h"

namespace hada {
namespace {

constexpr double most_stretch = 1.02;  // of one side against the other, or of both
constexpr double same_pitch = 1e-3;    // up to this share
constexpr double least_cutoff_px = 4.0;

// Which pixel of a surface shows what a pixel of the pictures does, along rows or columns.
struct Scale {
  double first = 0.0;  // of the pictures, that the surface shows
  double per_pixel = 1.0;

  double from_pictures(int pixel) const { return (pixel + 0.5 - first) * per_pixel - 0.5; }
  int to_pictures(int pixel) const { return int(std::floor((pixel + 0.5) / per_pixel + first)); }
};

struct Placement {
  Scale row, col;
};

bool differ(double a, double b) {
  return std::max(a, b) > most_stretch * std::min(a, b);
}

Placement placement_of(const Surface& known, bool is_map, const Extent& frame,
                       const std::string& name) {
  const auto& [rows, cols, pitch, unit] = known.extent;
  const auto size = [](const Extent& extent) {
    return fmt::format("{:.4g} x {:.4g} {}", extent.width(), extent.height(), name_of(extent.unit));
  };
  if (!is_map && std::abs(pitch - frame.pitch) < same_pitch * frame.pitch) {
    const Eigen::Vector2i& offset = known.offset_px;
    if (offset.minCoeff() < 0 || offset.y() > frame.rows - rows || offset.x() > frame.cols - cols) {
      throw Error(
          fmt::format("{}: lies beyond the pictures, by its offset_px; give a surface of "
                      "what they show",
                      name));
    }
    return {{double(offset.y()), 1.0}, {double(offset.x()), 1.0}};
  }
  const double down = double(rows) / frame.rows;
  const double right = double(cols) / frame.cols;
  const bool other_size = !is_map && differ(known.extent.width(), frame.width());
  if (differ(down, right) || other_size) {
    throw Error(
        fmt::format("{}: is {} x {} pixels, {}, the pictures are {} x {}, {}: they cannot "
                    "show the same; cut it to what the pictures show",
                    name, cols, rows, size(known.extent), frame.cols, frame.rows, size(frame)));
  }
  return {{0.0, down}, {0.0, right}};
}

// Linear between the known pixels of a surface, if they are nearer than the others.
float height_at(const Surface& surface, double row, double col) {
  const double r = std::clamp(row, 0.0, surface.extent.rows - 1.0);
  const double c = std::clamp(col, 0.0, surface.extent.cols - 1.0);
  double sum = 0.0, known = 0.0;
  for (const int down : {0, 1}) {
    for (const int right : {0, 1}) {
      const double share =
          (down ? r - int(r) : 1.0 - (r - int(r))) * (right ? c - int(c) : 1.0 - (c - int(c)));
      if (share == 0.0 || !surface.mask(int(r) + down, int(c) + right)) continue;
      sum += share * surface.height(int(r) + down, int(c) + right);
      known += share;
    }
  }
  return known >= 0.5 ? float(sum / known) : std::nanf("");
}

// The means of what falls into each pixel of `part`: of a surface whose pixels are no larger.
void gather(const Surface& known, const Placement& placement, const PixelBox& part,
            Grid<float>& heights) {
  Grid<double> sum(part.rows, part.cols, 0.0, heights.memory());
  Grid<std::int32_t> count(part.rows, part.cols, 0, heights.memory());
  for (int row = 0; row < known.extent.rows; ++row) {
    const int r = placement.row.to_pictures(row) - part.row;
    for (int col = 0; col < known.extent.cols; ++col) {
      const int c = placement.col.to_pictures(col) - part.col;
      if (!known.mask(row, col) || !sum.contains(r, c)) continue;
      sum(r, c) += known.height(row, col);
      ++count(r, c);
    }
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (count[i] > 0) heights[i] = float(sum[i] / count[i]);
  }
}

double cutoff_px_of(const PriorArguments& arguments, const Extent& frame) {
  if (!arguments.cutoff) {
    return std::max(0.25 * std::min(frame.rows, frame.cols), least_cutoff_px);
  }
  const double cutoff = *arguments.cutoff / frame.pitch;
  if (!(cutoff >= least_cutoff_px && std::isfinite(cutoff))) {
    throw Error(
        fmt::format("--cutoff {:.8g}: must be a wavelength of four pixels or more, which "
                    "are {:.8g} {}",
                    *arguments.cutoff, least_cutoff_px * frame.pitch, name_of(frame.unit)));
  }
  return cutoff;
}

}  // namespace

PriorHeights read_prior(const PriorArguments& arguments, const Extent& frame, const PixelBox& part,
                        std::pmr::memory_resource* where) {
  const std::string name = arguments.file->string();
  std::error_code ignored;  // `read_surface` says what is wrong
  const bool is_map = !std::filesystem::is_directory(*arguments.file, ignored);
  // A folder says its own unit, a height map has that of the surface.
  const Surface known = read_surface(
      *arguments.file,
      is_map && frame.unit == Unit::mm ? std::optional<double>(frame.pitch) : std::nullopt,
      SurfaceMaps::height_alone);
  if (!known.has_height()) {
    throw Error(name + ": holds no height; give a surface folder or a height map in floats");
  }
  if (known.extent.unit != frame.unit) {
    throw Error(fmt::format(
        "{}: has its heights in {}, but the surface is in {}; {}", name, name_of(known.extent.unit),
        name_of(frame.unit),
        frame.unit == Unit::mm ? "give a prior in mm, or leave --pitch out" : "give --pitch"));
  }
  PriorHeights prior{Grid<float>(part.rows, part.cols, std::nanf(""), where)};
  prior.cutoff_px = cutoff_px_of(arguments, frame);
  const Placement placement = placement_of(known, is_map, frame, name);
  if (placement.row.per_pixel >= 1.0 && placement.col.per_pixel >= 1.0) {
    gather(known, placement, part, prior.height);
  } else {
    for_each_index(part.rows, [&](int row) {
      for (int col = 0; col < part.cols; ++col) {
        prior.height(row, col) = height_at(known, placement.row.from_pictures(part.row + row),
                                           placement.col.from_pictures(part.col + col));
      }
    });
  }
  if (std::none_of(prior.height.begin(), prior.height.end(),
                   [](float height) { return std::isfinite(height); })) {
    throw Error(name + ": knows no height where the surface lies; give one of what it shows");
  }
  return prior;
}

std::string told_of_prior(const PriorArguments& arguments, const Surface& surface) {
  return fmt::format("waves longer than {:.4g} {} are those of {}", surface.levelling_cutoff,
                     name_of(surface.extent.unit), arguments.file->string());
}

}  // namespace hada
