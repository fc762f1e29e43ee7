#include "bench/knit_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "core/quantile.h"
#include "core/random.h"
#include "mechanics/knit_motion.h"
#include "mechanics/knit_rest.h"
#include "mechanics/taut_yarn.h"
#include "mechanics/wear_stocking.h"
#include "synth/leg.h"

namespace hada {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double ratio = 10.0, stretch = 1.5, noise = 0.02;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

KnitNet net_of(int count) {
  KnitNet net;
  net.courses = net.wales = count;
  net.stiffness = stiffness_of_courses(count, ratio);
  return net;
}

double farthest(const Places& a, const Places& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

// Crossings of 16 x 16 by the paper's steps, which the fit does not take.
std::vector<KnitState> exact(KnitPull pull, KnitClamp clamp) {
  std::vector<KnitState> states;
  for (const double to : {1.2, stretch}) {
    const auto knit = pulled(net_of(16), pull, clamp, to);
    states.push_back({pull, to, knit_motion(knit.net, knit.start, {.still = 1e-9}).places});
  }
  return states;
}

std::vector<KnitState> with_noise(std::vector<KnitState> states, double sigma, Seed seed) {
  for (std::size_t s = 0; s < states.size(); ++s) {
    for (std::size_t i = 0; i < states[s].places.size(); ++i) {
      for (int axis = 0; axis < 2; ++axis) {
        states[s].places[i][axis] += sigma * gaussian(seed, std::int64_t(s), std::int64_t(i), axis);
      }
    }
  }
  return states;
}

}  // namespace

PatchStudy study_patch() {
  PatchStudy study;
  for (const auto pull : {KnitPull::course, KnitPull::wale}) {
    for (const auto clamp : {KnitClamp::three_points, KnitClamp::uniform}) {
      const auto knit = pulled(net_of(10), pull, clamp, stretch);
      study.steps = int(knit_motion(knit.net, knit.start).motion.size());
      const auto end = knit_motion(knit.net, knit.start, {.still = 1e-12}).places;
      study.rest_apart =
          std::max(study.rest_apart, farthest(end, knit_at_rest(knit.net, knit.start).places));
    }
  }
  return study;  // the last one is that of the paper
}

double seconds_to_rest(int count) {
  double slower = 0.0;
  for (const auto pull : {KnitPull::wale, KnitPull::course}) {
    const auto knit = pulled(net_of(count), pull, KnitClamp::uniform, stretch);
    const auto start = Clock::now();
    if (!knit_at_rest(knit.net, knit.start).settled) return HUGE_VAL;
    slower = std::max(slower, seconds_since(start));
  }
  return slower;
}

namespace {

template <class Wear>
WearStudy study_wearing(const LegShape& leg, int count, const Wear& wear) {
  const Body body(leg_mesh(leg));
  WearStudy study;
  const auto start = Clock::now();
  const WornKnit knit = wear(body, {.courses = count, .wales = count});
  const auto yarns = taut_yarns(body, knit);
  study.seconds = seconds_since(start);
  study.steps = knit.steps, study.settled = knit.settled;
  study.cut = penetrating(body, knit, straight_lines(knit), 1e-6);
  study.penetrating = penetrating(body, knit, yarns.lines, 1e-6);
  return study;
}

}  // namespace

WearStudy study_wear(int count) {
  return study_wearing({}, count, worn);
}

WearStudy study_stocking(int count) {
  return study_wearing({.foot_mm = 230.0}, count, worn_stocking);
}

StiffnessStudy study_stiffness(int seeds) {
  struct Trial {
    double ratio_error, continuity_error, seconds;
    int inside;
  };
  std::vector<Trial> trials(static_cast<std::size_t>(seeds));
  constexpr auto clamp = KnitClamp::three_points;
  constexpr double deviations = 1.96;
  const auto at_rest = exact(KnitPull::wale, clamp);
  for_each_index(seeds, [&](int seed) {
    const auto states = with_noise(at_rest, noise, Seed(seed + 1));
    const auto start = Clock::now();
    const auto found = knit_stiffness(net_of(16), {0, 1}, clamp, states);
    const double log_error = std::log(found.ratio.value / ratio);
    const double error = found.continuity.value - 0.2;
    trials[std::size_t(seed)] = {found.ratio.value - ratio, error, seconds_since(start),
                                 (std::abs(log_error) < deviations * found.log_ratio_sigma) +
                                     (std::abs(error) < deviations * found.continuity.sigma)};
  });
  StiffnessStudy study;
  const auto bound = clamp_bounds(KnitPull::wale, clamp);
  study.ratio_bound = ratio * bound.log_ratio, study.continuity_bound = bound.continuity;
  std::vector<double> seconds;
  for (const Trial& trial : trials) {
    study.ratio_spread += trial.ratio_error * trial.ratio_error / seeds;
    study.continuity_spread += trial.continuity_error * trial.continuity_error / seeds;
    study.coverage += 0.5 * trial.inside / seeds;
    seconds.push_back(trial.seconds);
  }
  study.ratio_spread = std::sqrt(study.ratio_spread);
  study.continuity_spread = std::sqrt(study.continuity_spread);
  study.seconds_median = median(seconds);
  return study;
}

StiffnessBounds clamp_bounds(KnitPull pull, KnitClamp clamp) {
  return stiffness_bounds(net_of(16), {0, 1}, clamp, exact(pull, clamp), ratio, noise);
}

}  // namespace hada
