#pragma once

#include <cstdint>

#include "reconstruct/row_kernels.h"

/// The inner loops that make a level of the multigrid solver out of the finer one; compiled for
/// several instruction sets as those of `row_kernels` are.
namespace hada::coarsen_kernels {

/// The cells a and b of even and odd columns in the rows 0 and 1 of a row of blocks.
struct UnitRows {
  const std::uint8_t* a0;
  const std::uint8_t* b0;
  const std::uint8_t* a1;
  const std::uint8_t* b1;
  const std::uint8_t* a2;  // the first row of the block below
  const std::uint8_t* b2;
};
/// What joins the cells of a block among each other and with the blocks to the right and below.
///
/// inside_across, inside_along  sums of the edges within a block, along its rows and its columns
/// cross_across, cross_along    to the block on the right, to the block below
/// split                        not 0 where the cells of a block do not hang together
void join(int n, const UnitRows& codes, float* __restrict inside_across,
          float* __restrict inside_along, float* __restrict cross_across,
          float* __restrict cross_along, float* __restrict split);

struct WeightedRows {
  const float* ab0;  // edges
  const float* ba0;
  const float* ab1;
  const float* ba1;
  const float* a01;
  const float* b01;
  const float* a12;
  const float* b12;
  const float* a0;  // inverses
  const float* b0;
  const float* a1;
  const float* b1;
};
/// An edge below `least` of all edges at one of its ends does not count as hanging together.
void join(int n, const WeightedRows& rows, float least, float* __restrict inside_across,
          float* __restrict inside_along, float* __restrict cross_across,
          float* __restrict cross_along, float* __restrict split);

/// cross = 1 / (1 / cross + reach + reach_beyond), 0 where cross is 0: edges in series.
void in_series(int n, float* __restrict cross, const float* reach, const float* reach_beyond);
/// reach = 1 / (2 reach), 0 stays 0.
void to_reach(int n, float* __restrict reach);
/// 1 for the cells of an even lattice, 0 for all others.
void find_even(int n, const row_kernels::Around& weight, const float* reach_across,
               const float* reach_along, const float* inverse, std::uint8_t* __restrict even);
/// inverse = 1 / (sum of weights), 0 where there are none.
void invert(int n, float* __restrict inverse, const row_kernels::Around& weight);

}  // namespace hada::coarsen_kernels
