#pragma once

#include <span>

#include "core/random.h"

namespace hada {

/// Fills `row` with independent normal numbers of mean 0 and variance 1.
///
/// The number at each place is a function of seed, row and place. It is another function than
/// `gaussian` and five times as fast, for blocks of millions.
///
/// Source: Marsaglia and Tsang, The ziggurat method, Journal of Statistical Software 5 (2000), over
/// the stream of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
void fill_white_noise(std::span<float> row, Seed seed, int row_number);

}  // namespace hada
