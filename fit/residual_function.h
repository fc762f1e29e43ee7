#pragma once

#include <functional>

namespace hada {

/// Fills the residuals at `packed` and, unless `jacobian` is null, their derivatives, a row each.
using ResidualFunction =
    std::function<void(const double* packed, double* residuals, double* jacobian)>;

}  // namespace hada
