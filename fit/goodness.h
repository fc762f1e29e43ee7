#pragma once

#include <vector>

#include "fit/cells.h"

namespace hada {

/// The probability that a true model would explain the cells as badly as `model` does.
///
/// Neighbouring cells are pooled into log-polar patches; each patch compares its mean of P / S with
/// 1 by the deviance of a gamma variable, and the sum of those is held against a chi-square law.
///
/// model         expected power of every cell
/// independence  of the spectrum
/// fields        how many fields were fitted
double goodness_of_fit(const std::vector<Cell>& cells, const std::vector<double>& model,
                       double independence, int fields);

}  // namespace hada
