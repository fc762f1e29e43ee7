#pragma once

#include "synth/wood.h"

// The field table of `Wood`, apart from it because it is long; included by synth/wood.h.
namespace hada {

template <class T>
constexpr auto Wood<T>::lists() {
  using L = NumberList<Wood, T>;
  return std::tuple{
      L{"pith_mm", &Wood::pith_mm, 2, 2, -1e5, 1e5, Scale::linear, "mm",
        "x and y of the pith where z is 0"},
      L{"pith_lean", &Wood::pith_lean, 2, 2, -1.0, 1.0, Scale::linear, "",
        "mm by which the pith moves along x and y for each mm of z"},
      L{"ring_radii_mm", &Wood::ring_radii_mm, 0, 4096, 1e-3, 1e5, Scale::linear, "mm",
        "effective radius where latewood meets the earlywood of the next ring, rising"},
      L{"early_rgb", &Wood::early_rgb, 3, 3, 0.0, 1.0, Scale::linear, "",
        "linear albedo of earlywood: red, green, blue"},
      L{"late_rgb", &Wood::late_rgb, 3, 3, 0.0, 1.0, Scale::linear, "",
        "linear albedo of latewood"},
      L{"cut_origin_mm", &Wood::cut_origin_mm, 3, 3, -1e5, 1e5, Scale::linear, "mm",
        "place in the stem of the centre of the picture"},
      L{"cut_right", &Wood::cut_right, 3, 3, -1.0, 1.0, Scale::linear, "",
        "direction in the stem that is to the right in the picture"},
      L{"cut_up", &Wood::cut_up, 3, 3, -1.0, 1.0, Scale::linear, "",
        "direction in the stem that is up in the picture"},
  };
}

template <class T>
constexpr auto Wood<T>::fields() {
  using F = Field<Wood, T>;
  return std::array{
      F{"taper", &Wood::taper, -1.0, 1.0, Scale::linear, "",
        "mm by which the effective radius of a place grows for each mm of z"},
      F{"wobble_mm", &Wood::wobble_mm, 0.0, 100.0, Scale::linear, "mm",
        "largest fractal departure of a ring from its lobes"},
      F{"latewood_share", &Wood::latewood_share, 0.01, 1.0, Scale::linear, "",
        "share of a ring, its outermost, that is latewood"},
      F{"latewood_onset", &Wood::latewood_onset, 0.0, 1.0, Scale::linear, "",
        "share of the latewood over which it darkens"},
      F{"spiral", &Wood::spiral, -2.0, 2.0, Scale::linear, "",
        "fibre gradient g1 of spiral grain, a slope"},
      F{"wave_amplitude", &Wood::wave_amplitude, 0.0, 2.0, Scale::linear, "",
        "fibre gradient A of wavy grain, a slope"},
      F{"wave_length_mm", &Wood::wave_length_mm, 0.1, 1e4, Scale::log, "mm",
        "length of a wave along the stem"},
      F{"wave_phase_rad", &Wood::wave_phase_rad, -3.15, 3.15, Scale::linear, "rad",
        "phase of the wave at the height of z = 0"},
      F{"interlock_amplitude", &Wood::interlock_amplitude, 0.0, 2.0, Scale::linear, "",
        "fibre gradient of interlocked grain, a slope"},
      F{"interlock_period", &Wood::interlock_period, 0.2, 1e4, Scale::log, "rings",
        "rings from one lean to the same again"},
      F{"interlock_phase_rad", &Wood::interlock_phase_rad, -3.15, 3.15, Scale::linear, "rad",
        "phase of the interlocked grain at the pith"},
      F{"fluctuation", &Wood::fluctuation, 0.0, 1.0, Scale::linear, "",
        "largest fractal departure of the fibre gradient"},
      F{"fluctuation_mm", &Wood::fluctuation_mm, 0.1, 1e4, Scale::log, "mm",
        "size of the largest fluctuations"},
      F{"fibre_shift", &Wood::fibre_shift, 0.0, 1.0, Scale::linear, "",
        "largest share by which a fibre is lighter or darker"},
      F{"fibre_mm", &Wood::fibre_mm, 1e-3, 100.0, Scale::log, "mm", "size of a bundle of fibres"},
      F{"vessel_density_per_mm2", &Wood::vessel_density_per_mm2, 0.0, 1e4, Scale::linear, "1/mm^2",
        "vessels anywhere in the end grain"},
      F{"vessel_radius_mm", &Wood::vessel_radius_mm, 1e-3, 5.0, Scale::log, "mm",
        "mean radius of these vessels"},
      F{"vessel_radius_sd_mm", &Wood::vessel_radius_sd_mm, 0.0, 5.0, Scale::linear, "mm",
        "standard deviation of their radius"},
      F{"ring_vessels_per_mm", &Wood::ring_vessels_per_mm, 0.0, 1e3, Scale::linear, "1/mm",
        "vessels for each mm of ring boundary (ring-porous wood)"},
      F{"ring_vessel_radius_mm", &Wood::ring_vessel_radius_mm, 1e-3, 5.0, Scale::log, "mm",
        "mean radius of those at a ring boundary"},
      F{"vessel_shade", &Wood::vessel_shade, 0.0, 1.0, Scale::linear, "",
        "brightness of a vessel beside the wood around it"},
      F{"figure_specular", &Wood::figure_specular, 0.0, 10.0, Scale::linear, "",
        "specular coefficient of the fibres over the diffuse one"},
      F{"figure_sharpness", &Wood::figure_sharpness, 0.0, 1e4, Scale::linear, "",
        "exponent n of the specular reflection"},
      F{"figure_light_rad", &Wood::figure_light_rad, -1.58, 1.58, Scale::linear, "rad",
        "incidence of the light, positive up the stem"},
  };
}

}  // namespace hada
