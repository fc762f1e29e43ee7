#include "fit/solve.h"

#include <array>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/scalar.h"

namespace hada {
namespace {

/// A decaying wave: y(t) = height exp(-rate t) cos(turn + t).
template <class T = double>
struct Wave {
  T height{1.0};
  T rate{0.1};
  T turn{0.0};

  static constexpr auto fields() {
    using F = Field<Wave, T>;
    return std::array{F{"height", &Wave::height, 0.01, 100.0, Scale::log, "", ""},
                      F{"rate", &Wave::rate, 0.0, 5.0, Scale::linear, "", ""},
                      F{"turn", &Wave::turn, 0.0, 3.15, Scale::half_turn, "", ""}};
  }
};

constexpr int samples = 50;
constexpr double noise = 0.01;

template <class T>
T wave_at(const Wave<T>& wave, double t) {
  using std::cos;
  using std::exp;
  return wave.height * exp(-wave.rate * t) * cos(wave.turn + t);
}

auto misfit(const Wave<>& truth) {
  return [truth](const auto& wave, auto* r) {
    for (int i = 0; i < samples; ++i) {
      const double t = 0.1 * i;
      r[i] = (wave_at(wave, t) - wave_at(truth, t)) / noise;
    }
  };
}

TEST(Solve, FindsTheTruthFromAnyOfSeveralStarts) {
  const Wave<> truth{2.0, 0.5, 0.7};
  const auto fit =
      solve(std::vector{Wave<>{1.0, 0.1, 0.0}, Wave<>{9.0, 1.0, 1.0}}, samples, misfit(truth));
  // Without noise the cost falls to rounding.
  EXPECT_NEAR(fit.material.height, 2.0, 1e-6);
  EXPECT_NEAR(fit.material.rate, 0.5, 1e-6);
  EXPECT_NEAR(fit.material.turn, 0.7, 1e-6);
  EXPECT_EQ(fit.starts, 2);
  EXPECT_GE(fit.agreeing, 1);
  EXPECT_TRUE(fit.on_bound.empty());
}

TEST(Solve, NamesTheFieldThatEndedOnItsBound) {
  const Wave<> growing{2.0, -0.2, 0.0};  // its rate is below the low bound
  const auto fit = solve(std::vector{Wave<>{1.0, 0.5, 0.1}}, samples, misfit(growing));
  EXPECT_EQ(fit.on_bound, std::vector<std::string>{"rate"});
  EXPECT_EQ(fit.sigma.rate, 0.0);
  EXPECT_GT(fit.sigma.height, 0.0);
}

TEST(Solve, GivesTheSigmaOfALinearProblem) {
  // With rate and turn at the truth the height is a linear parameter: its sigma, were it alone,
  // would be noise / |basis|. The others can only add to it; the covariance must be the inverse of
  // J^T J in any case.
  const Wave<> truth{2.0, 0.5, 0.7};
  const auto fit = solve(std::vector{truth}, samples, misfit(truth));
  double square = 0.0;
  for (int i = 0; i < samples; ++i) square += std::pow(wave_at(Wave<>{1.0, 0.5, 0.7}, 0.1 * i), 2);
  EXPECT_GE(fit.sigma.height, noise / std::sqrt(square));
  const auto jacobian = jacobian_of(truth, samples, misfit(truth));
  const Eigen::MatrixXd unit = fit.covariance * (jacobian.transpose() * jacobian);
  EXPECT_TRUE(unit.isIdentity(1e-6)) << unit;
}

TEST(Solve, TellsTheGapToTheRunnerUp) {
  // Cost with two valleys in the rate, at 1 (depth 0) and 3 (depth 2).
  const auto valleys = [](const auto& wave, auto* r) {
    const auto x = wave.rate;
    r[0] = 4.0 * (x - 1.0) * (x - 3.0);
    r[1] = x - 1.0;
    r[2] = wave.height - 1.0;
    r[3] = wave.turn;
  };
  const auto fit = solve(
      std::vector{Wave<>{1.0, 3.2, 0.0}, Wave<>{1.0, 0.8, 0.0}, Wave<>{2.0, 1.2, 0.0}}, 4, valleys);
  EXPECT_NEAR(fit.material.rate, 1.0, 1e-6);
  EXPECT_EQ(fit.agreeing, 2);
  EXPECT_NEAR(fit.runner_up_gap, 2.0, 0.2);  // the second valley lies a little before 3
}

TEST(Solve, HasTheSameAnswerAtAnyThreadCount) {
  const std::vector starts{Wave<>{1.0, 0.1, 0.0}, Wave<>{9.0, 1.0, 1.0}, Wave<>{0.2, 2.0, 2.0}};
  const auto run = [&](int count) {
    set_threads(count);
    const auto fit = solve(starts, samples, misfit({2.0, 0.5, 0.7}));
    set_threads(0);
    return pack(fit.material);
  };
  EXPECT_EQ(run(1), run(3));
}

TEST(Solve, ThrowsWhenNoStartIsFinite) {
  const auto broken = [](const auto& wave, auto* r) { r[0] = wave.height * std::nan(""); };
  EXPECT_THROW(solve(std::vector{Wave<>{}}, 1, broken), Error);
}

TEST(CovarianceOf, IsLargeButFiniteWhereNothingIsKnown) {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2, 2);
  information(0, 0) = 4.0;
  const auto covariance = covariance_of(information, {true, true});
  EXPECT_DOUBLE_EQ(covariance(0, 0), 0.25);
  EXPECT_DOUBLE_EQ(covariance(1, 1), 1e12);
}

}  // namespace
}  // namespace hada
