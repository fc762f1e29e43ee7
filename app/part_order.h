#pragma once

#include <vector>

#include "synth/material.h"

/// A fit returns the parts of a material in an order of its own; here they meet those of the truth.
namespace hada {

/// How many parts the (first) list of the material holds; 0 if it has none.
int part_count(const Material& material);

/// Which part of `found` stands for each part of `truth`: the assignment with the smallest sum of
/// squared log-ratios of their sizes. Parts left over explain something else, such as the noise of
/// the measurement. Empty if there are too few or none.
std::vector<int> part_order(const Material& found, const Material& truth);

/// The parts that `order` names, in that order.
Material reordered(const Material& material, const std::vector<int>& order);

/// All values in the order of the field table.
std::vector<double> values_of(const Material& material);

}  // namespace hada
