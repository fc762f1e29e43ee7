#pragma once

#include <cstdint>
#include <span>

#include "core/random.h"

namespace hada {

/// The normal number of mean 0 and variance 1 that 64 well-mixed bits decide.
///
/// Another number than `gaussian` makes of a key, and five times as fast, for fields of millions.
/// Source: Marsaglia and Tsang, The ziggurat method, Journal of Statistical Software 5 (2000), over
/// the stream of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
double normal_of(std::uint64_t bits);

/// Fills `row` with independent normal numbers of mean 0 and variance 1.
///
/// The number at each place is a function of seed, row and place.
void fill_white_noise(std::span<float> row, Seed seed, int row_number);

}  // namespace hada
