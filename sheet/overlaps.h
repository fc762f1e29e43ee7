#pragma once

#include <cstdint>
#include <vector>

#include "sheet/flat_fold.h"
#include "sheet/sheet.h"

namespace hada {

/// A set of small numbers, fast to meet with another.
class BitSet {
 public:
  BitSet() = default;
  explicit BitSet(int size) : words_(std::size_t(size + 63) / 64, 0) {}
  bool has(int i) const { return (words_[std::size_t(i) / 64] >> (i % 64)) & 1u; }
  void toggle(int i) { words_[std::size_t(i) / 64] ^= std::uint64_t(1) << (i % 64); }
  bool meets(const BitSet& other) const {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      if (words_[k] & other.words_[k]) return true;
    }
    return false;
  }
  std::vector<int> members() const;
  BitSet operator&(const BitSet& other) const {
    BitSet both = *this;
    for (std::size_t k = 0; k < words_.size(); ++k) both.words_[k] &= other.words_[k];
    return both;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Which faces of a flat-folded sheet lie over each other, cell by cell.
///
/// A cell is a piece of the plane that no edge crosses. Which faces cover it is found by walking
/// from the outside across edges, so it depends on how edges are joined and never on rounding.
struct Overlaps {
  std::vector<BitSet> faces_of;              // of each cell
  std::vector<BitSet> cells_of;              // of each face
  std::vector<std::array<int, 2>> sides_of;  // of each segment: cells left and right, -1 outside
  std::vector<std::vector<int>> edges_of;    // of each segment: edges of the sheet that lie on it
};

Overlaps overlaps(const Sheet& sheet, const FlatState& state);

}  // namespace hada
