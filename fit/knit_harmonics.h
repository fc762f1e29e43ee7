#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/parallel.h"
#include "fit/knit_picture.h"
#include "synth/knit.h"

namespace hada {

/// The six numbers that say where stitches are, in the order of `lattice_fields`.
inline constexpr int lattice_field_count = 6;
using LatticeFields = Eigen::Matrix<double, lattice_field_count, 1>;
LatticeFields lattice_fields(const Knit<>& knit);
Knit<> with_lattice_fields(Knit<> knit, const LatticeFields& fields);

/// The pattern of `h` waves across a wale and `k` up a period.
struct Harmonic {
  int h, k;
};

/// The rows and columns of the part of the picture that is looked at.
struct Window {
  int row, col, rows, cols;
};

/// The middle of a picture, `share` of it along each side, 8 pixels at least.
Window middle_of(const Extent& extent, double share);

/// Phases of the lattice along a row of pixels in cycles, and how they turn with the six numbers.
struct RowPhases {
  Eigen::ArrayX2d cycles;
  Eigen::Matrix<double, Eigen::Dynamic, lattice_field_count> wale_turn, course_turn;
};

RowPhases phases_of(const Knit<>& knit, const Extent& extent, const Window& window, int row);

/// exp(2 pi i (h wale + k course)) of every harmonic, a column each.
Eigen::ArrayXXcd pattern(const std::vector<Harmonic>& harmonics, const RowPhases& phases);

/// The strongest harmonics of the pattern where `knit` says that it lies.
std::vector<Harmonic> strongest(const KnitPicture& picture, const Window& window,
                                const Knit<>& knit, int courses);

/// Sums over the rows of a window, each row apart and then in order.
template <class Sums, class Add>
Sums summed(const Window& window, const Sums& zero, const Add& add) {
  std::vector<Sums> rows(std::size_t(window.rows), zero);
  for_each_index(window.rows, [&](int r) { add(rows[std::size_t(r)], window.row + r); });
  Sums total = zero;
  for (const Sums& sums : rows) total += sums;
  return total;
}

}  // namespace hada
