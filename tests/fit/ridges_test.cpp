#include "fit/ridges.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

const Extent extent{160, 160, 0.2, Unit::mm};
const Wrinkle<> plain{.components = {{0.3, 1.0, 0.7, 0.5}, {0.04, 0.5, 0.4, 2.0}},
                      .floor_mm4 = 1e-8};

/// A cut from the middle of a larger field, with noise: it does not tile, as those of the fit do.
Grid<float> sheet(double skew, double tail, double sharpness, Seed seed) {
  Wrinkle<> wrinkle = plain;
  wrinkle.skew = skew;
  wrinkle.tail = tail;
  wrinkle.sharpness = sharpness;
  const Extent world{400, 400, 0.2, Unit::mm};
  return crop(synthesize(wrinkle, world, seed).height, 100, 100, extent.rows, extent.cols);
}

Fit<Wrinkle<>> known(const Wrinkle<>& wrinkle) {
  Fit<Wrinkle<>> spectrum;
  spectrum.material = wrinkle;
  return spectrum;
}

RidgeFit fitted(const Grid<float>& height) {
  return fit_ridges(height, Mask(height.rows(), height.cols(), 1), known(plain),
                    {height.rows(), height.cols(), 0.2, Unit::mm});
}

TEST(FitRidges, FindsWhatLiesOverTheSheet) {
  const RidgeFit fit = fitted(sheet(0.3, 0.1, 2.0, 40));
  const Eigen::Vector3d truth(0.3, 0.1, 2.0), widest(0.3, 0.3, 1.0);
  for (int k = 0; k < 3; ++k) {
    // Beyond four sigma once in 16000; and a sigma that says something: a part of the bounds.
    EXPECT_NEAR(fit.value[k], truth[k], 4.0 * fit.sigma[k]) << k;
    EXPECT_LT(fit.sigma[k], widest[k]) << k;
  }
  EXPECT_GT(fit.evidence.departure, 50.0);
  EXPECT_GT(fit.evidence.explained(), 0.8);
  EXPECT_LT(fit.evidence.ridged.curvature, 0.5 * fit.evidence.gaussian.curvature);
  EXPECT_NE(told(fit).find("ridges explain"), std::string::npos);
}

TEST(FitRidges, TellsFurrowsFromRidges) {
  const RidgeFit fit = fitted(sheet(0.0, 0.0, -2.0, 41));
  EXPECT_LT(fit.value[2], -2.0 * fit.sigma[2]);
}

TEST(FitRidges, FindsNoneOnAGaussianSheet) {
  const RidgeFit fit = fitted(sheet(0.0, 0.0, 0.0, 30));
  for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(fit.value[k]), 4.0 * fit.sigma[k]) << k;
  EXPECT_LT(fit.evidence.departure, 22.5);  // a chi-square of six, in 99.9 %
}

TEST(FitRidges, IsLessSureWhereTheSpectrumIs) {
  const Extent small{96, 96, 0.2, Unit::mm};
  const auto height = crop(sheet(0.3, 0.0, 2.0, 42), 0, 0, small.rows, small.cols);
  auto spectrum = known(plain);
  const RidgeFit sure = fit_ridges(height, full_mask(small), spectrum, small);
  const auto fields = Eigen::Index(pack(plain).size());
  spectrum.covariance = 0.09 * Eigen::MatrixXd::Identity(fields, fields);  // 30 % of each
  spectrum.covariance.bottomRightCorner(3, 3).setZero();
  const RidgeFit unsure = fit_ridges(height, full_mask(small), spectrum, small);
  EXPECT_GT(unsure.sigma[2], sure.sigma[2]);
}

TEST(FitRidges, HasTheSameBytesAtAnyThreadCount) {
  const auto height = crop(sheet(0.3, 0.0, 2.0, 42), 0, 0, 64, 64);
  set_threads(1);
  const RidgeFit alone = fitted(height);
  set_threads(3);
  const RidgeFit shared = fitted(height);
  set_threads(0);
  EXPECT_EQ(alone.value, shared.value);
  EXPECT_EQ(alone.sigma, shared.sigma);
}

TEST(FitRidges, AsksForEnoughPixels) {
  EXPECT_THROW(fitted(crop(sheet(0.0, 0.0, 0.0, 43), 0, 0, 24, 24)), Error);
}

}  // namespace
}  // namespace hada
