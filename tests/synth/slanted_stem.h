#pragma once

#include "synth/wood.h"

namespace hada {

/// A slanted cut of a stem that leans, tapers, bulges and turns in every way.
inline Wood<> slanted_stem() {
  Wood<> wood;
  wood.pith_mm = {-3.0, 2.0};
  wood.pith_lean = {0.05, -0.03};
  wood.taper = 0.02;
  wood.lobes = {{2, 0.05, -0.03, 0.0, 0.0}, {3, 0.02, 0.04, 4.0, 12.0}};
  wood.spiral = 0.1;
  wood.wave_amplitude = 0.15;
  wood.wave_length_mm = 20.0;
  wood.interlock_amplitude = 0.2;
  wood.fluctuation = 0.02;
  wood.fibre_shift = 0.3;
  wood.fibre_mm = 2.0;
  wood.cut_origin_mm = {4.0, 1.0, 3.0};
  wood.cut_up = {0.0, 0.6, 0.8};
  return wood;
}

}  // namespace hada
