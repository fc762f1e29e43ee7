#pragma once

#include "core/grid.h"
#include "reconstruct/dealt.h"
#include "reconstruct/zeroed.h"

/// Sums over all cells of a level; rows are added up in order, whatever the number of threads.
namespace hada {

double dot(const Dealt& at, const Cells& a, const Cells& b);

/// total += factor x; a map is not dealt.
void add_times(const Dealt& at, double factor, const Cells& x, Cells& total);
void add_times(const Dealt& at, double factor, const Cells& x, Grid<float>& total);

/// From at.rows + 2 rows of at.stride() values, as `at` deals them, to a map, in the same memory.
void undeal(const Dealt& at, Grid<float>& values);

}  // namespace hada
