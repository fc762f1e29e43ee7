#pragma once

#include <vector>

namespace hada {

/// A statistic with one part of the sample left out, and how many times larger the whole is than
/// that part.
struct LeftOut {
  double value;
  double whole_over_part;  // > 1
};

/// The standard error of a statistic that is `whole` on the whole sample, from what it is without
/// each of its parts; NaN for fewer than two. Parts must be longer than what they share.
///
/// Source: Busing, Meijer, van der Leeden, Statistics and Computing 9 (1999), eq. 8.
double jackknife_sigma(double whole, const std::vector<LeftOut>& left_out);

}  // namespace hada
