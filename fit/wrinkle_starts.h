#pragma once

#include <vector>

#include "fit/cells.h"
#include "measure/spectrum.h"
#include "synth/wrinkle.h"

namespace hada {

/// Wrinkles with `components` noise functions that might explain `spectrum`, the likelier first.
///
/// Each start places its noise functions at other frequencies: at equal shares of the power of the
/// rings, of their fall in decades, or of the octaves between. Density and direction are read off
/// the rings and sectors there: the long axis lies across the sector of most power.
std::vector<Wrinkle<>> wrinkle_starts(const Spectrum& spectrum, int components, int starts);

/// A start with its fields moved inside their bounds.
Wrinkle<> within_bounds(Wrinkle<> wrinkle);

/// `wrinkle` with one more noise function where `cells` hold more power than `model` explains.
Wrinkle<> with_one_more(const Wrinkle<>& wrinkle, const std::vector<Cell>& cells,
                        const std::vector<double>& model);

}  // namespace hada
