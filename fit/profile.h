#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/field.h"
#include "fit/residual_function.h"

namespace hada {

/// Narrows the bounds of the other fields while one is held at `value`: an order that fields keep.
using WhileHeld = std::function<void(double value, std::vector<SolverBounds>& bounds)>;

constexpr double rise_of_one = 3.84;  // the 95 % points of chi-squared of one degree of freedom
constexpr double rise_of_two = 5.99;  // and of two

/// The residuals while the field is held at `value`: half of their sum of squares is a negative
/// logarithm of a likelihood. They may depend on it by more than the field that they are given.
using ResidualsWhileHeld = std::function<ResidualFunction(double value)>;

/// The interval of one packed field by its profile likelihood: where the deviance, the other fields
/// at their best for each value of it, is at most `rise` above the least.
///
/// packed    where the residuals are smallest
/// spread    a guess of the field's standard deviation, for the first step; 0: there is none
/// returns   the lower and the upper end; an end that the data do not tell lies on its bound
///
/// Source: Venzon and Moolgavkar, Applied Statistics 37 (1988).
std::array<double, 2> profile_interval(const std::vector<double>& packed, int field, double spread,
                                       double rise, const std::vector<SolverBounds>& bounds,
                                       int residual_count, const ResidualsWhileHeld& residuals,
                                       const WhileHeld& while_held = {});

}  // namespace hada
