#include "synth/synthesize.h"

#include <cmath>
#include <string>
#include <variant>

#include "core/error.h"
#include "synth/endless.h"
#include "synth/gaussian_field.h"
#include "synth/ridges.h"

namespace hada {
namespace {

constexpr float plain_albedo = 0.8f;

template <Spectral M>
Grid<float> field_of(const M& material, const Extent& extent, Seed seed) {
  return gaussian_field(spectrum_of(material), extent, seed);
}

// Ridges are of the paper, not of the white noise over it.
Grid<float> field_of(const Wrinkle<>& wrinkle, const Extent& extent, Seed seed) {
  const auto window = window_of_tile(wrinkle, extent);
  if (!has_ridges(wrinkle)) return gaussian_field(spectrum_of(wrinkle, window), extent, seed);
  Wrinkle<> bare = wrinkle;
  bare.floor_mm4 = 0.0;
  auto field =
      with_ridges(gaussian_field(spectrum_of(bare, window), extent, seed), wrinkle, extent.pitch);
  if (wrinkle.floor_mm4 == 0.0) return field;
  const auto floor =
      gaussian_field([&](double, double) { return wrinkle.floor_mm4; }, extent, mixed(seed, 1));
  for (std::size_t i = 0; i < field.size(); ++i) field[i] += floor[i];
  return field;
}

// A fact of the spectrum alone: luck draws the phases, and the sheet is of one colour.
template <Spectral M>
Surface drawn(const M& material, const Extent& extent, Seed seed) {
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.height = field_of(material, extent, seed);
  surface.normals = normals_of(surface.height, surface.mask, extent.pitch);
  surface.albedo = Image(Grid<float>(extent.rows, extent.cols, plain_albedo));
  return surface;
}

void check(const Extent& extent) {
  if (extent.rows < 1 || extent.cols < 1) {
    throw Error("synthesis: the surface has no pixels; ask for at least 1 x 1");
  }
  if (!std::isfinite(extent.pitch) || extent.pitch <= 0.0) {
    throw Error("synthesis: the pitch is not a positive number; give the size of a pixel");
  }
}

Surface window_of(const Wrinkle<>& wrinkle, const Extent& window,
                  const std::array<double, 2>& middle, Seed seed) {
  // A pixel more on each side, so that the slopes at the border are those of its neighbour.
  const Extent wider{window.rows + 2, window.cols + 2, window.pitch, window.unit};
  const auto height = endless_field(wrinkle, wider, middle, seed);
  Surface surface;
  surface.extent = window;
  surface.mask = full_mask(window);
  surface.normals =
      crop(normals_of(height, full_mask(wider), window.pitch), 1, 1, window.rows, window.cols);
  surface.height = crop(height, 1, 1, window.rows, window.cols);
  surface.albedo = Image(Grid<float>(window.rows, window.cols, plain_albedo));
  return surface;
}

Surface window_of(const Wood<>& wood, const Extent& window, const std::array<double, 2>& middle,
                  Seed seed) {
  return surface_of(with_cut_moved(wood, middle), window, seed);
}

template <class M>
Surface window_of(const M&, const Extent&, const std::array<double, 2>&, Seed) {
  throw Error("synthesis: " + std::string(M::name) +
              " is made as a whole; windows can be cut from wrinkle and wood alone");
}

}  // namespace

Surface synthesize_window(const Material& material, const Extent& window,
                          const std::array<double, 2>& middle, Seed seed) {
  check(window);
  constexpr double farthest_px = 1e8;  // where a place is still known to a millionth of a pixel
  for (const double along : middle) {
    if (!(std::abs(along) <= farthest_px * window.pitch)) {
      throw Error(
          "synthesis: the middle of the window is no place within 10^8 pixels; give two "
          "numbers nearer to 0");
    }
  }
  return std::visit([&](const auto& known) { return window_of(known, window, middle, seed); },
                    material);
}

Surface synthesize(const Material& material, const Extent& extent, Seed seed) {
  check(extent);
  return std::visit(
      [&](const auto& known) {
        if constexpr (Grown<std::decay_t<decltype(known)>>) {
          return surface_of(known, extent, seed);
        } else {
          return drawn(known, extent, seed);
        }
      },
      material);
}

}  // namespace hada
