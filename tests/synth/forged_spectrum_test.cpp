#include "synth/forged_spectrum.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "core/fft.h"

namespace hada {
namespace {

/// The mean power of what one place of the pile becomes, over a block: the block's spectrum is the
/// sum of such, because the places are independent.
TEST(ForgedSpectrum, IsThatOfTheHammeredPile) {
  for (const std::string sequence : {"C", "R", "CRC", "RCCR", "CCCR", "RRRC"}) {
    for (const auto kernel : {HammerKernel::both, HammerKernel::stretched}) {
      // A single place in the middle of the last pile, hammered out by the paper's steps: its cuts
      // lie before the first letter, so that the block is blank wherever it is folded.
      const int rows = 128, cols = 128;
      Grid<double> h(rows, cols);
      const int down = 1 << std::count(sequence.begin(), sequence.end(), 'R');
      const int along = 1 << std::count(sequence.begin(), sequence.end(), 'C');
      h(rows / down / 2, cols / along / 2) = 1.0;
      for (const char cut : sequence) {
        Grid<double> stretched(rows, cols), smooth(rows, cols);
        for (int i = 0; i < rows; ++i) {
          for (int j = 0; j < cols; ++j) stretched(i, j) = cut == 'C' ? h(i, j / 2) : h(i / 2, j);
        }
        const int u_most = kernel == HammerKernel::both || cut == 'R' ? 1 : 0;
        const int v_most = kernel == HammerKernel::both || cut == 'C' ? 1 : 0;
        for (int i = 0; i < rows; ++i) {
          for (int j = 0; j < cols; ++j) {
            for (int u = -u_most; u <= u_most; ++u) {
              for (int v = -v_most; v <= v_most; ++v) {
                if (stretched.contains(i + u, j + v))
                  smooth(i, j) += stretched(i + u, j + v) / ((2 * u_most + 1) * (2 * v_most + 1));
              }
            }
          }
        }
        h = smooth;
      }
      const auto half = fft(h);
      for (int i = 0; i <= rows / 2; i += 7) {
        for (int j = 0; j <= cols / 2; j += 5) {
          // A place in 2^N, of variance 2^-N of the block's, is doubled to 2^N places: 4^N in all.
          const double expected = std::norm(half(i, j)) / std::pow(4.0, double(sequence.size()));
          EXPECT_NEAR(psd(sequence, kernel, double(j) / cols, double(i) / rows), expected, 1e-12)
              << sequence << " " << i << " " << j;
        }
      }
    }
  }
}

TEST(ForgedSpectrum, IsSeenThroughTheView) {
  const Forged<> forged{.sequence = "CCR"};
  const ForgedView<> plain;
  EXPECT_DOUBLE_EQ(psd(forged, plain, 0.07, 0.02), psd("CCR", HammerKernel::both, 0.07, 0.02));
  ForgedView<> view{.scale = 2.0, .blur_px = 1.5, .variance = 3.0, .floor = 0.25};
  const double pi = std::numbers::pi;
  const double blur = std::exp(-4.0 * pi * pi * 2.25 * (0.03 * 0.03 + 0.01 * 0.01));
  EXPECT_NEAR(psd(forged, view, 0.03, 0.01),
              12.0 * blur * psd("CCR", HammerKernel::both, 0.06, 0.02) + 0.25, 1e-12);
  view = {.rotation_rad = pi / 2.0};
  EXPECT_NEAR(psd(forged, view, -0.02, 0.07), psd("CCR", HammerKernel::both, 0.07, 0.02), 1e-12);
  view = {.aspect = 0.5};
  EXPECT_NEAR(psd(forged, view, 0.14, 0.02), 0.5 * psd("CCR", HammerKernel::both, 0.07, 0.02),
              1e-12);
}

}  // namespace
}  // namespace hada
