#pragma once

#include <cmath>

#include "core/random.h"
#include "core/surface.h"
#include "synth/wood.h"

namespace hada {

/// A stem by the luck of `seed`; widths of rings hang together as in nature (AR(1), 0.65).
Wood<> made_stem(Seed seed);

/// What a camera sees of its cut: drawn `finer` times finer, noise of 1 %, 8 bits.
Surface picture_of(const Wood<>& wood, const Extent& extent, Seed seed, int finer = 3);

/// How many 90 % intervals hold the truth.
struct Tally {
  int held = 0, asked = 0;

  void add(double error, double sigma) {
    constexpr double ninety = 1.6449;  // deviations that hold 90 % of a Gaussian
    ++asked;
    if (std::abs(error) <= ninety * sigma) ++held;
  }
  void add(const Tally& other) {
    held += other.held;
    asked += other.asked;
  }
  double share() const { return asked > 0 ? double(held) / asked : 0.0; }
};

}  // namespace hada
