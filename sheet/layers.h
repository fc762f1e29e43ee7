#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sheet/flat_fold.h"
#include "sheet/sheet.h"

namespace hada {

struct LayerOptions {
  std::vector<FaceOrder> chosen = {};  // orders that must hold, `other` as it lies in the flat
                                       // sheet's folded state, its printed side up or down
  std::uint64_t most = 1000000000000000000u;  // states of one part, where counting ends
  bool count = true;                          // all states, not one alone
};

/// The orders in which the faces of a flat-folded sheet can lie over each other.
struct Layers {
  bool possible = false;
  std::string reason;                      // if not: where the layers block each other
  std::vector<FaceOrder> order;            // one state, of all pairs of faces that overlap
  std::vector<std::uint64_t> part_states;  // parts that can be ordered independently
  int overlapping_pairs = 0;

  /// All states: the product over the parts, written out in full.
  std::string states() const;
};

/// Orders the layers so that no paper passes through paper.
///
/// Faces that share a fold are ordered by it. Where folds or faces meet along a line: two folds on
/// the same side must not interlock (taco-taco), a face must not pass through a fold
/// (taco-tortilla), and faces that run on side by side keep their order (tortilla-tortilla). Where
/// three faces overlap their orders must not run in a circle (transitivity).
///
/// Source: Akitaya, Cheung, Demaine, Horiyama, Hull, Ku, Tachi, Uehara, Box pleating is hard,
/// JCDCGG 2015; the conditions go back to Justin, Aspects mathematiques du pliage de papier, 1989.
Layers layer_orders(const Sheet& sheet, const FlatState& state, const LayerOptions& options = {});

}  // namespace hada
