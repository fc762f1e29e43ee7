#pragma once

#include "core/grid.h"

namespace hada {

/// A picture whose grey values have been drawn apart by a curve, to mean 0 and variance 1.
struct Scores {
  Grid<float> values;
  double log_slope = 0.0;  // mean over the pixels of the logarithm of the curve's slope
};

/// The grey values of a picture as they would be if their distribution were normal, in their order.
///
/// The curve is a smooth one through the normal scores of all ranks, so that it undoes the tone of
/// a picture but does not pull apart what noise or quantising has put between two levels.
///
/// throws  Error if all values are equal
///
/// Source: van der Waerden, Order tests for the two-sample problem, Indagationes Math. 14 (1952).
Scores normal_scores(const Grid<float>& values);

/// The grey values as they are, but for mean and variance: the curve of a picture without a tone.
Scores standard_scores(const Grid<float>& values);

/// The number below which a normal variable of mean 0 and variance 1 lies with `probability`.
double normal_quantile(double probability);

}  // namespace hada
