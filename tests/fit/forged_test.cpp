#include "fit/forged.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/srgb.h"
#include "synth/forged.h"

namespace hada {
namespace {

/// A photograph of the middle of a block: 8 bits, 10 % noise, and a tone of its own.
Surface photographed(const std::string& sequence, const Extent& extent, Seed seed, double noise,
                     bool quantised) {
  auto block = forged_block({.sequence = sequence}, {1024, 2048}, seed);
  quantise(block, 70.0, quantised ? 5.0 : 0.0);
  Grid<float> grey = crop(block, 301, 407, extent.rows, extent.cols);
  double sum = 0.0, squares = 0.0;
  for (const float g : grey) {
    sum += g;
    squares += double(g) * g;
  }
  const auto n = double(grey.size());
  const double deviation = std::sqrt(squares / n - sum * sum / (n * n));
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const double noisy = grey(row, col) + noise * deviation * gaussian(seed + 1, row, col);
      const double tone = std::pow(std::clamp((noisy + 20.0) / 110.0, 0.0, 1.0), 0.7);
      const double stored = noise > 0.0 ? std::round(255.0 * tone) / 255.0 : tone;
      grey(row, col) = linear_from_srgb(float(stored));
    }
  }
  surface.albedo = Image(grey);
  return surface;
}

class ForgedFits : public ::testing::TestWithParam<std::string> {};

TEST_P(ForgedFits, NamesTheSequenceOfANoisyPicture) {
  const int folds = int(GetParam().size());
  const auto fit =
      fit_forged(photographed(GetParam(), {512, 1024}, 11, 0.1, true),
                 {.fewest_folds = folds - 1, .most_folds = folds + 1, .view = GrainView::block});
  EXPECT_EQ(fit.material.sequence, GetParam());
  EXPECT_GT(fit.posterior.front().probability, 0.5);
  // Deviances of cells of many ordinates have mean 1; 4000 of them scatter by 2.2 %, and a tenth
  // is left to the series that stands for the error of quantising.
  EXPECT_LT(fit.deviance, 1.2);
  // The noise is 10 % before the tone, whose slope varies by some 10 % over the picture.
  EXPECT_NEAR(std::sqrt(fit.nuisance.floor), 0.1, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Sequences, ForgedFits, ::testing::Values("CRCRCR", "CCCCC", "RRCRCC"));

TEST(ForgedFit, NamesTheSequenceOfACleanPicture) {
  const auto fit = fit_forged(photographed("RCRRCC", {256, 384}, 12, 0.0, false),
                              {.most_folds = 7, .view = GrainView::block});
  EXPECT_EQ(fit.material.sequence, "RCRRCC");
  EXPECT_GT(fit.posterior.front().probability, 0.99);
}

TEST(ForgedFit, NamesTheSequenceOfAWholeBlockWithLevels) {
  // Most of its power is grain and most of its cells are the error of quantising, whose slopes
  // another sequence may take for its own.
  Surface surface;
  surface.extent = {400, 600};
  surface.mask = full_mask(surface.extent);
  auto block = forged_block({.sequence = "CRRRRRC"}, {400, 600}, 15);
  quantise(block, 70.0, 5.0);
  for (float& g : block) g = linear_from_srgb(std::round(255.0f * g / 70.0f) / 255.0f);
  surface.albedo = Image(std::move(block));
  const auto fit =
      fit_forged(surface, {.fewest_folds = 6, .most_folds = 8, .view = GrainView::block});
  EXPECT_EQ(fit.material.sequence, "CRRRRRC");
  EXPECT_GT(fit.posterior.front().probability, 0.9);
}

TEST(ForgedFit, GivesProbabilitiesThatSumToOne) {
  const auto fit = fit_forged(photographed("CRRC", {128, 128}, 13, 0.3, true),
                              {.most_folds = 6, .view = GrainView::block});
  double sum = 0.0;
  for (const auto& one : fit.posterior) sum += one.probability;
  EXPECT_NEAR(sum, 1.0, 1e-3);  // those below 1e-6 are not listed
  EXPECT_NEAR(fit.kinds.masame + fit.kinds.itame + fit.kinds.mokume, 1.0, 1e-12);
}

TEST(ForgedFit, ReportsAsOneWhatNoDataCanTellApart) {
  // Under a kernel along the stretched axis alone the order of the folds leaves no trace.
  const auto picture = photographed("CRC", {128, 256}, 14, 0.1, true);
  const auto fit = fit_forged(picture, {.fewest_folds = 3,
                                        .most_folds = 3,
                                        .kernel = HammerKernel::stretched,
                                        .view = GrainView::block});
  for (const auto& one : fit.posterior) {
    const auto cuts = std::count(one.sequences[0].begin(), one.sequences[0].end(), 'C');
    EXPECT_EQ(one.sequences.size(), cuts == 1 || cuts == 2 ? 3u : 1u);
  }
}

TEST(ForgedFit, IsTheSameAtAnyThreadCount) {
  const auto picture = photographed("CRC", {96, 96}, 15, 0.1, true);
  set_threads(1);
  const auto alone = fit_forged(picture, {.fewest_folds = 3, .most_folds = 4});
  set_threads(3);
  const auto shared = fit_forged(picture, {.fewest_folds = 3, .most_folds = 4});
  set_threads(0);
  EXPECT_EQ(alone.material.sequence, shared.material.sequence);
  EXPECT_EQ(alone.cost, shared.cost);
  EXPECT_EQ(alone.posterior.front().probability, shared.posterior.front().probability);
}

TEST(ForgedFit, RefusesWhatShowsNoGrain) {
  Surface grey;
  grey.extent = {128, 128};
  grey.mask = full_mask(grey.extent);
  grey.albedo = Image(Grid<float>(128, 128, 0.3f));
  EXPECT_THROW(fit_forged(grey), Error);
  grey.extent = {20, 20};
  grey.albedo = Image(Grid<float>(20, 20, 0.3f));
  EXPECT_THROW(fit_forged(grey), Error);
}

}  // namespace
}  // namespace hada
