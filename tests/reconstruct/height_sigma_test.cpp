#include "reconstruct/height_sigma.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "reconstruct/integrate.h"
#include "scenes.h"

namespace hada {
namespace {

struct Uncertain {
  Relief relief;
  Grid<float> normal_sigma;
  Mask mask;
};

// A disc with a hole, twice as uncertain on its right side.
Uncertain disc(int size) {
  Uncertain disc{waves(size, size), Grid<float>(size, size), Mask(size, size, 0)};
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const Eigen::Vector2d place = disc.relief.extent.place(row, col);
      const bool in_hole = (place - Eigen::Vector2d(0.0, 0.2 * size)).norm() < 0.06 * size;
      disc.mask(row, col) = place.norm() < 0.48 * size && !in_hole;
      disc.normal_sigma(row, col) = place.x() > 0.0 ? 0.02f : 0.01f;
    }
  }
  return disc;
}

Grid<float> brute_force(const Uncertain& disc, int draws, Levelling levelling = Levelling::plane,
                        const PriorHeights* prior = nullptr, const Grid<float>& weight = {}) {
  const int size = disc.mask.rows();
  const auto levelled = [&](const NormalMap& normals) {
    auto height = integrate(normals, disc.mask, 1.0, {.tolerance_px = 1e-3, .weight = weight});
    if (prior) {
      level(height, disc.mask, *prior);
    } else {
      level(height, disc.mask, levelling);
    }
    return height;
  };
  const auto truth = levelled(disc.relief.normals);
  Grid<float> variance(size, size);
  for (int draw = 0; draw < draws; ++draw) {
    NormalMap normals = disc.relief.normals;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Eigen::Vector3f across = normals[i].unitOrthogonal();
      const auto key = std::int64_t(i);
      normals[i] += disc.normal_sigma[i] *
                    (float(gaussian(9, key, draw, 0)) * across +
                     float(gaussian(9, key, draw, 1)) * disc.relief.normals[i].cross(across));
      normals[i].normalize();
    }
    const auto height = levelled(normals);
    for (std::size_t i = 0; i < height.size(); ++i) {
      variance[i] += (height[i] - truth[i]) * (height[i] - truth[i]) / float(draws);
    }
  }
  for (float& value : variance) value = std::sqrt(value);
  return variance;
}

// The share of the pixels whose sigma is within 15 % of its truth.
double share_of_close(const Uncertain& known, const Grid<float>& sigma, const Grid<float>& truth) {
  double inside = 0.0;
  double close = 0.0;
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    if (!known.mask[i]) continue;
    inside += 1.0;
    close += std::abs(sigma[i] - truth[i]) < 0.15 * truth[i];
  }
  return close / inside;
}

TEST(HeightSigma, AgreesWithBruteForce) {
  const Uncertain known = disc(80);
  const auto sigma =
      height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0, Levelling::plane);
  for (std::size_t i = 0; i < sigma.size(); ++i) EXPECT_EQ(sigma[i] > 0.0f, known.mask[i] != 0);
  // The truth is good to 5 %, long waves to 3 (512 draws), the rest to 12 (32 draws) of a fifth of
  // the variance: 15 % are more than two deviations, and what is off is off over whole regions.
  EXPECT_GT(share_of_close(known, sigma, brute_force(known, 200)), 0.9);
}

TEST(HeightSigma, KnowsThatAPriorTakesTheLongWaves) {
  const Uncertain known = disc(80);
  PriorHeights prior{Grid<float>(80, 80, std::nanf("")), 30.0};
  for (std::size_t i = 0; i < prior.height.size(); i += 3) {
    prior.height[i] = float(known.relief.height[i]);
  }
  const auto sigma = height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0,
                                  Levelling::plane, &prior);
  const auto plane =
      height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0, Levelling::plane);
  // Not where the variance, which rises towards the border within less than the 6 px that it is
  // smoothed over, is a mean of what lies further inside.
  Uncertain deep = known;
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      for (int r = row - 6; r <= row + 6; ++r) {
        for (int c = col - 6; c <= col + 6; ++c) {
          if (!known.mask.contains(r, c) || !known.mask(r, c)) deep.mask(row, col) = 0;
        }
      }
    }
  }
  const auto truth = brute_force(known, 200, Levelling::plane, &prior);
  EXPECT_GT(share_of_close(deep, sigma, truth), 0.9);
  EXPECT_LT(sigma(40, 10), 0.8f * plane(40, 10));
}

double rms(const Grid<float>& sigma, const Mask& mask) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    if (!mask[i]) continue;
    squares += double(sigma[i]) * sigma[i];
    count += 1.0;
  }
  return std::sqrt(squares / count);
}

TEST(HeightSigma, KnowsHowMuchPixelsCount) {
  // A chessboard: the pixels of its black squares are 20 times as uncertain, and count 1 / 400.
  Uncertain known = disc(80);
  Grid<float> weight(80, 80, 1.0f);
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      const bool black = (row / 8 + col / 8) % 2 == 0;
      known.normal_sigma(row, col) = black ? 0.06f : 0.003f;
      weight(row, col) = black ? 1.0f : 400.0f;
    }
  }
  const auto sigma = height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0,
                                  Levelling::plane, nullptr, &weight);
  const auto truth = brute_force(known, 200, Levelling::plane, nullptr, weight);
  // Some ten long waves make most of it: 200 draws know each variance to 10 %, the root of their
  // sum to 2 %, and so do 512 draws.
  EXPECT_NEAR(rms(sigma, known.mask) / rms(truth, known.mask), 1.0, 0.06);
  const auto alike =
      height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0, Levelling::plane);
  EXPECT_GT(rms(alike, known.mask), 1.2 * rms(sigma, known.mask));
}

TEST(HeightSigma, IsThatOfThePiecesOfATornSurface) {
  // Squares of 5 x 5 pixels, one pixel apart: the lattice of the long waves joins them all.
  constexpr int size = 60;
  Uncertain torn = disc(size);
  std::fill(torn.normal_sigma.begin(), torn.normal_sigma.end(), 0.01f);
  Mask& mask = torn.mask;
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) mask(row, col) = row % 6 != 5 && col % 6 != 5;
  }
  mask(59, 59) = 1;  // alone, so known
  const auto sigma =
      height_sigma(torn.relief.normals, torn.normal_sigma, mask, 1.0, Levelling::offset);
  const auto truth = brute_force(torn, 200, Levelling::offset);
  double ratio = 0.0;
  double pixels = 0.0;
  for (std::size_t i = 0; i < sigma.size(); ++i) {
    if (!mask[i] || truth[i] < 1e-6f) continue;  // that pixel but for rounding
    // Smoothed over 13 x 13 pixels, sigma is that of a usual pixel of a square; clamped to half and
    // double of a variance that 32 draws know to 25 %.
    EXPECT_GT(sigma[i], 0.4f * truth[i]);
    EXPECT_LT(sigma[i], 2.5f * truth[i]);
    ratio += sigma[i] / truth[i];
    pixels += 1.0;
  }
  EXPECT_GT(pixels, 2400.0);
  EXPECT_GT(ratio / pixels, 0.7);
  EXPECT_LT(ratio / pixels, 1.45);
}

TEST(HeightSigma, GrowsWithTheLogarithmOfTheSize) {
  // In the middle of a large square of slope variance v, each octave adds v ln 2 / (2 pi); the
  // largest of these is drawn on a lattice of half the pixels, so this tests what that adds.
  const auto middle = [](int size) {
    const NormalMap normals(size, size, Eigen::Vector3f::UnitZ());
    const Grid<float> normal_sigma(size, size, 0.01f);
    const auto sigma =
        height_sigma(normals, normal_sigma, Mask(size, size, 1), 1.0, Levelling::offset);
    double sum = 0.0;  // over the middle half, to know it better
    for (int row = size / 4; row < 3 * size / 4; ++row) {
      for (int col = size / 4; col < 3 * size / 4; ++col) sum += std::pow(sigma(row, col), 2);
    }
    return sum / (size * size / 4.0) / (0.01 * 0.01);
  };
  const double octave = std::log(2.0) / (2.0 * std::numbers::pi);
  // The same draws on the same cells stand behind both, but for what 4 x 4 of them leave out.
  EXPECT_NEAR(middle(512) - middle(256), octave, 0.5 * octave);
}

TEST(HeightSigma, ScalesWithPitchAndNormalSigma) {
  const Uncertain known = disc(40);
  const auto one =
      height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0, Levelling::plane);
  Grid<float> twice = known.normal_sigma;
  for (float& sigma : twice) sigma *= 2.0f;
  const auto other = height_sigma(known.relief.normals, twice, known.mask, 0.1, Levelling::plane);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_NEAR(other[i], 0.2f * one[i], 1e-4f * one[i]);
  }
}

TEST(HeightSigma, GivesTheSameBytesAtAnyThreadCount) {
  const Uncertain known = disc(50);
  const auto run = [&](int count) {
    set_threads(count);
    return height_sigma(known.relief.normals, known.normal_sigma, known.mask, 1.0,
                        Levelling::plane);
  };
  const auto one = run(1);
  const auto two = run(2);
  set_threads(0);
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace hada
