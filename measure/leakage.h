#pragma once

#include "measure/spectrum.h"

namespace hada {

/// Where the power of a periodogram comes from: a taper lets strong frequencies shine into weak
/// ones through its side lobes.
struct Leakage {
  Grid<double> near;  // unit^4: from at most `reach` frequency steps away, the ordinate included
  Grid<double> far;   // unit^4: from further away; where it rivals `near` nothing is known
  double far_share = 0.0;  // how much of a flat spectrum comes from far away
};

/// The power of every ordinate, as the taper's spectral window collects it from the measured power.
///
/// reach  in frequency steps: beyond it a contribution counts as leakage
Leakage leakage(const Spectrum& spectrum, double reach = 4.0);

}  // namespace hada
