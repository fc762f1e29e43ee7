#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/extent.h"
#include "core/field.h"
#include "core/random.h"
#include "core/surface.h"
#include "synth/cut.h"
#include "synth/growth.h"
#include "synth/ripples.h"

namespace hada {

/// A stem of wood, solid, and the plane it is cut by.
///
/// Frame of the stem: x and y span the end grain, z runs up the stem. Fibres lean by
/// G = spiral + wave + interlock + fluctuation, the slope d(arc)/dz on their ring, positive
/// counter-clockwise seen from above; colour and vessels are those of the plane z = 0, carried up
/// along the fibres. Source: Kawai, IPSJ Journal 41(3), 2000, sections 4 to 7.
template <class T = double>
struct Wood {
  static constexpr std::string_view name = "wood";
  static constexpr std::string_view summary = "a stem with rings, fibres and vessels, and a cut";

  std::vector<GrowthLobe<T>> lobes{{T(2.0)}, {T(3.0)}};
  std::vector<T> pith_mm{T(0.0), T(0.0)};
  std::vector<T> pith_lean{T(0.0), T(0.0)};
  std::vector<T> ring_radii_mm{T(4.4), T(8.1), T(12.7), T(17.6)};
  std::vector<T> early_rgb{T(0.72), T(0.50), T(0.29)};
  std::vector<T> late_rgb{T(0.36), T(0.19), T(0.085)};
  std::vector<T> cut_origin_mm{T(0.0), T(0.0), T(0.0)};
  std::vector<T> cut_right{T(1.0), T(0.0), T(0.0)};
  std::vector<T> cut_up{T(0.0), T(1.0), T(0.0)};

  T taper{0.0};
  T wobble_mm{0.0};
  T latewood_share{0.35};
  T latewood_onset{0.75};
  T spiral{0.0};
  T wave_amplitude{0.0};
  T wave_length_mm{40.0};
  T wave_phase_rad{0.0};
  T interlock_amplitude{0.0};
  T interlock_period{8.0};
  T interlock_phase_rad{0.0};
  T fluctuation{0.0};
  T fluctuation_mm{30.0};
  T fibre_shift{0.0};
  T fibre_mm{0.2};
  T vessel_density_per_mm2{0.0};
  T vessel_radius_mm{0.05};
  T vessel_radius_sd_mm{0.01};
  T ring_vessels_per_mm{0.0};
  T ring_vessel_radius_mm{0.12};
  T vessel_shade{0.4};
  T figure_specular{0.0};
  T figure_sharpness{20.0};
  T figure_light_rad{0.0};

  static constexpr auto parts() {
    return std::tuple{PartList<Wood, GrowthLobe<T>>{"lobes", &Wood::lobes, 0, 1024}};
  }
  static constexpr auto lists();
  static constexpr auto fields();
};

/// The cut, as a picture: the centre of `extent` lies at cut_origin_mm, x along cut_right, y along
/// cut_up; the albedo has three planes, there is no height. `seed` decides wobble, fluctuation,
/// fibres and vessels.
///
/// ripples  how this one stem departs from what `wood` can say
/// throws   Error if cut_right and cut_up do not span a plane
Surface surface_of(const Wood<>& wood, const Extent& extent, Seed seed,
                   const Ripples& ripples = {});

/// The plane that `wood` says it is cut along.
/// throws  Error if cut_right and cut_up do not span a plane
Cut cut_of(const Wood<>& wood);

/// The same stem, the centre of its cut moved within the plane: by[0] mm along x of the picture,
/// by[1] along y.
Wood<> with_cut_moved(Wood<> wood, const std::array<double, 2>& by);

}  // namespace hada

#include "synth/wood_fields.h"
