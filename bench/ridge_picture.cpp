#include "bench/ridge_picture.h"

#include <algorithm>

#include "app/draw/lettering.h"
#include "app/draw/maps.h"
#include "app/files.h"
#include "fit/wrinkle.h"
#include "io/output.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr int side_px = 300, gap_px = 8;
constexpr int nearer = 3;  // times, in the lower row

Surface middle_of(const Surface& sheet) {
  const int rows = sheet.extent.rows / nearer, cols = sheet.extent.cols / nearer;
  const Extent extent{rows, cols, sheet.extent.pitch, sheet.extent.unit};
  Surface part;
  part.extent = extent;
  part.mask = full_mask(extent);
  part.height = crop(sheet.height, rows, cols, rows, cols);
  part.normals = crop(sheet.normals, rows, cols, rows, cols);
  return part;
}

Image enlarged(const Image& picture, int times) {
  Image larger(picture.rows() * times, picture.cols() * times, int(picture.planes.size()));
  for (std::size_t c = 0; c < picture.planes.size(); ++c) {
    for (int row = 0; row < larger.rows(); ++row) {
      for (int col = 0; col < larger.cols(); ++col)
        larger.planes[c](row, col) = picture.planes[c](row / times, col / times);
    }
  }
  return larger;
}

void put(Image& page, const Image& tile, int row, int col) {
  for (std::size_t c = 0; c < page.planes.size(); ++c) {
    for (int r = 0; r < tile.rows(); ++r) {
      for (int k = 0; k < tile.cols(); ++k) page.planes[c](row + r, col + k) = tile.planes[c](r, k);
    }
  }
}

}  // namespace

void write_ridges_picture(const std::filesystem::path& path) {
  Wrinkle<> truth{.components = {{0.30, 2.6, 1.7, 0.6}, {0.04, 0.9, 0.6, 2.2}}};
  truth.skew = 0.25;
  truth.sharpness = 3.2;
  const Extent extent{side_px, side_px, 0.2, Unit::mm};
  const Surface measured = synthesize(truth, extent, 8);
  const auto ridged = fit_wrinkle(measured, {.components = 2, .ridges = true}).material;
  Wrinkle<> gaussian = ridged;
  gaussian.skew = gaussian.tail = gaussian.sharpness = 0.0;
  const std::vector<Surface> sheets{measured, synthesize(gaussian, extent, 9),
                                    synthesize(ridged, extent, 9)};

  Image page(2 * side_px + gap_px, 3 * (side_px + gap_px) - gap_px, 3);
  for (auto& plane : page.planes) std::fill(plane.begin(), plane.end(), 1.0f);
  const ReliefStyle style = relief_style(measured);
  constexpr Colour white{1.0f, 1.0f, 1.0f};
  for (int k = 0; k < 3; ++k) {
    const Surface& sheet = sheets[std::size_t(k)];
    auto whole = relief_picture(sheet, style);
    auto part = enlarged(relief_picture(middle_of(sheet), style), nearer);
    draw_scale_bar(whole, extent.pitch, white);
    draw_scale_bar(part, extent.pitch / nearer, white);
    if (k == 2) draw_colour_bar(whole, style.height.low, style.height.high, "mm", white);
    put(page, whole, 0, k * (side_px + gap_px));
    put(page, part, side_px + gap_px, k * (side_px + gap_px));
  }
  Output output(path.parent_path().empty() ? "." : path.parent_path());
  put_picture(output, path.filename().string(), page);
  output.commit();
}

}  // namespace hada
