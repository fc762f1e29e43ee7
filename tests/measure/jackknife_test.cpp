#include "measure/jackknife.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(JackknifeSigma, OfAMeanIsItsStandardError) {
  // With equal parts the jackknife of a mean is exactly the deviation over the root of their
  // number.
  const std::vector<double> parts{1.0, 4.0, 2.0, 7.0, 6.0};
  const double mean = 4.0;
  std::vector<LeftOut> left_out;
  double squares = 0.0;
  for (const double part : parts) {
    left_out.push_back({(5.0 * mean - part) / 4.0, 5.0});
    squares += (part - mean) * (part - mean);
  }
  EXPECT_NEAR(jackknife_sigma(mean, left_out), std::sqrt(squares / 4.0 / 5.0), 1e-12);
}

TEST(JackknifeSigma, TakesPartsOfUnequalSize) {
  // 400 numbers of variance 1 in parts of 10 and 30: the mean is known to 1 / sqrt(400) = 0.05. A
  // sigma from 20 parts scatters by 1 / sqrt(2 19) = 16 %; its mean square over 50 draws by 3.3 %.
  double mean_square = 0.0;
  for (Seed seed = 0; seed < 50; ++seed) {
    double sum = 0.0;
    std::vector<double> sums, sizes;
    for (int i = 0, part = 0; i < 400; ++part) {
      const int size = part % 2 ? 30 : 10;
      sums.push_back(0.0);
      sizes.push_back(size);
      for (int k = 0; k < size; ++k, ++i) sums.back() += gaussian(seed, i);
      sum += sums.back();
    }
    std::vector<LeftOut> left_out;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      left_out.push_back({(sum - sums[k]) / (400.0 - sizes[k]), 400.0 / sizes[k]});
    }
    mean_square += std::pow(jackknife_sigma(sum / 400.0, left_out), 2) / 50.0;
  }
  EXPECT_NEAR(std::sqrt(mean_square), 0.05, 0.1 * 0.05);
}

TEST(JackknifeSigma, OfOnePartIsNotKnown) {
  EXPECT_TRUE(std::isnan(jackknife_sigma(1.0, {{1.0, 2.0}})));
}

}  // namespace
}  // namespace hada
