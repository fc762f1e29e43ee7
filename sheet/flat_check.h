#pragma once

#include <string>
#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Why a vertex cannot be folded flat.
struct FlatFlaw {
  int vertex = 0;
  std::string reason;  // a sentence that names the theorem and its numbers
};

/// The vertices inside the sheet around which the paper does not fold flat.
///
/// Kawasaki: the angles between folds, taken alternately, sum to half a turn each. It is judged by
/// how far the paper would gape at the end of the shortest fold, against `tolerance` times the
/// size of the sheet. Maekawa: mountains and valleys differ by two (where all are assigned).
/// Creases that are flat do not count.
///
/// Source: Hull, On the mathematics of flat origamis, Congressus Numerantium 100 (1994).
std::vector<FlatFlaw> flat_flaws(const Sheet& sheet, double tolerance = 1e-4);

}  // namespace hada
