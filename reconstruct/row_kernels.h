#pragma once

#include <cstdint>

/// The inner loops of the multigrid solver, each over half a row (`Dealt`) of one colour.
///
/// They are compiled for several instruction sets, and the best one of the processor is chosen when
/// the program starts. Nothing is contracted or reordered, so all of them give the same bytes.
namespace hada::row_kernels {

/// What surrounds half a row: values, or the weights of the edges that lead there.
struct Around {
  const float* up;
  const float* down;
  const float* left;
  const float* right;
};

struct AroundCodes {
  const std::uint8_t* up;
  const std::uint8_t* down;
  const std::uint8_t* left;
  const std::uint8_t* right;
};

/// One byte that says how many edges a pixel of a mask has, 4 at most: the number in the low half,
/// 12 over it, a whole number for all of them, in the high half.
constexpr std::uint8_t edge_code(int edges) {
  return std::uint8_t(edges == 0 ? 0 : edges | (12 / edges) << 4);
}

/// The code of every pixel of a row of a mask; `here` has a place before its first pixel and one
/// after its last.
void edge_codes(int n, const std::uint8_t* above, const std::uint8_t* here,
                const std::uint8_t* below, std::uint8_t* __restrict codes);

/// x = (right + sum of neighbours) / edges: Gauss-Seidel where every edge weighs 1.
///
/// Values outside the mask are 0 and all neighbours in the mask are joined, so the sum needs no
/// mask of its own. Pixels without edges become 0. x is rounded to a multiple of
/// magic / (3 * 2^22), or of half of that below -2^22 of them: (x + magic) - magic; not with a
/// magic of 0.
void relax(int n, float magic, float* __restrict x, const Around& value, const float* right,
           const std::uint8_t* code);
/// The same with a weight on every edge; inverse is 1 over their sum, 0 for a lonely cell.
///
/// Where 16 cells together are `even` (1: all edges weigh 1 and all reaches are 1/4), what weighs
/// them is not read; null: none are.
void relax(int n, float* __restrict x, const Around& value, const Around& weight,
           const float* right, const float* inverse, const std::uint8_t* even);

/// x += factor * (what `relax` would make of it - x): successive over-relaxation.
void over_relax(int n, float factor, float magic, float* __restrict x, const Around& value,
                const float* right, const std::uint8_t* code);
void over_relax(int n, float factor, float* __restrict x, const Around& value, const Around& weight,
                const float* right, const float* inverse, const std::uint8_t* even);

/// The same where x and all neighbours are 0.
void relax_from_zero(int n, float factor, float* __restrict x, const float* right,
                     const std::uint8_t* code);
void relax_from_zero(int n, float factor, float* __restrict x, const float* right,
                     const float* inverse);

/// out = right - A x. With codes as good as x is rounded: for corrections, which are small.
void residual(int n, float* __restrict out, const float* x, const Around& value, const float* right,
              const std::uint8_t* code);
void residual(int n, float* __restrict out, const float* x, const Around& value,
              const Around& weight, const float* right, const float* inverse,
              const std::uint8_t* even);
/// The same from differences of neighbours, which hardly round at all. `out` may be `right`.
void exact_residual(int n, float* out, const float* x, const Around& value, const float* right,
                    const std::uint8_t* code, const AroundCodes& around);

/// Half a row of coarse cells and what is next to them on one side, across and along.
struct Corner {
  const float* value;
  const float* across;         // values of the neighbours to the left or right
  const float* across_weight;  // of the edges to them
  const float* across_reach;   // of the cells: 1 over twice what joins their halves
  const float* along;          // up or down
  const float* along_weight;
  const float* along_reach;
  const std::uint8_t* even;
};

/// x[j] += factor * the value of coarse cell j carried to one of its corners, where `alive[j]` is
/// not 0: v + f (v_across - v) + g (v_along - v), f and g = weight * reach, the share of the way
/// between two cells that is covered at the corner; a quarter in an even lattice. n: a multiple
/// of 8.
void add_carried(int n, float factor, float* __restrict x, const Corner& even, const Corner& odd,
                 const std::uint8_t* alive);
void add_carried(int n, float factor, float* __restrict x, const Corner& even, const Corner& odd,
                 const float* alive);

}  // namespace hada::row_kernels
