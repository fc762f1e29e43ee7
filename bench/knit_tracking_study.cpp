#include "bench/knit_tracking_study.h"

#include <chrono>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "core/random.h"
#include "fit/knit.h"
#include "fit/knit_photographs.h"
#include "mechanics/knit_motion.h"
#include "synth/knit_photograph.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double ratio = 10.0, continuity = 0.2, pitch_mm = 0.1;
constexpr int side = 16;

Knit<> yarns() {
  Knit<> knit;
  knit.wale_mm = 2.0, knit.course_mm = 1.5, knit.yarn_radius_mm = 0.3, knit.loop_depth_mm = 0.24;
  knit.colour_repeat = {0.0, 1.0};
  knit.yarns = {{0.15, 0.25, 0.4}, {0.7, 0.6, 0.3}};
  return knit;
}

KnitNet net_of(int count) {
  KnitNet net;
  net.courses = net.wales = count;
  net.wale_length = 2.0, net.course_length = 1.5;
  net.stiffness = stiffness_of_courses(count, ratio);
  net.continuity = continuity;
  return net;
}

Surface photographed(const BentKnit& bent, int rows, int cols, Seed seed) {
  Surface surface;
  surface.extent = {rows, cols, pitch_mm, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = knit_photograph(yarns(), bent, surface.extent, seed);
  return surface;
}

// Sum of squares of what is left of `places` once shift, turn and scale are taken out, and how many
// were seen.
struct Left {
  double squares = 0.0;
  int seen = 0;
};

Left left_of(const Places& places, const Places& truth) {
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const auto rows = [&](std::size_t i) {
    Eigen::Matrix<double, 2, 4> r;
    r << truth[i].x(), -truth[i].y(), 1.0, 0.0, truth[i].y(), truth[i].x(), 0.0, 1.0;
    return r;
  };
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!places[i].allFinite()) continue;
    gram += rows(i).transpose() * rows(i);
    right += rows(i).transpose() * places[i].head<2>();
  }
  const Eigen::Vector4d frame = gram.ldlt().solve(right);
  Left left;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!places[i].allFinite()) continue;
    left.squares += (places[i].head<2>() - rows(i) * frame).squaredNorm();
    ++left.seen;
  }
  return left;
}

}  // namespace

TrackingStudy study_tracking(int trials) {
  TrackingStudy study{.trials = trials};
  constexpr double deviations = 1.96;
  Left all;
  for (int trial = 0; trial < trials; ++trial) {
    const Seed seed = 1000 * Seed(trial + 1);
    const auto flat = pulled(net_of(24), KnitPull::wale, KnitClamp::uniform, 1.0);
    const Surface rest = photographed({24, 24, flat.start}, 280, 360, seed);
    std::vector<KnitPhotograph> photographs;
    std::vector<Places> truth;
    for (const double stretch : {1.2, 1.5}) {
      const auto knit = pulled(net_of(side), KnitPull::wale, KnitClamp::three_points, stretch);
      Places places = knit_motion(knit.net, knit.start, {.still = 1e-9}).places;
      const auto key = std::int64_t(10.0 * stretch);
      const double turn = 0.03 * (2.0 * uniform(seed, key, 1) - 1.0);
      const Vector3d shift(2.0 * uniform(seed, key, 2) - 1.0, 2.0 * uniform(seed, key, 3) - 1.0,
                           0.0);
      for (auto& p : places) {
        p = Vector3d(std::cos(turn) * p.x() - std::sin(turn) * p.y(),
                     std::sin(turn) * p.x() + std::cos(turn) * p.y(), 0.0) +
            shift;
      }
      photographs.push_back({photographed({side, side, places}, 460, 460, seed + Seed(key)),
                             KnitPull::wale, stretch});
      truth.push_back(std::move(places));
    }
    const auto start = std::chrono::steady_clock::now();
    const Knit<> knit = fit_knit(rest).material;
    std::vector<int> repeat;
    for (const double yarn : knit.colour_repeat) repeat.push_back(yarn > 0.5);
    PulledKnitFit fit;
    try {
      fit = fit_photographs(rest, knit, repeat, photographs, {side, side, KnitClamp::three_points});
    } catch (const Error&) {
      continue;  // counted as not found
    }
    study.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++study.found;
    for (std::size_t s = 0; s < truth.size(); ++s) {
      const Left left = left_of(fit.states[s].places, truth[s]);
      all.squares += left.squares, all.seen += left.seen;
    }
    const auto& found = fit.stiffness;
    const double ratio_off = found.ratio.value - ratio;
    const double continuity_off = found.continuity.value - continuity;
    study.ratio_error += ratio_off * ratio_off;
    study.ratio_sigma += found.ratio.sigma * found.ratio.sigma;
    study.continuity_error += continuity_off * continuity_off;
    study.continuity_sigma += found.continuity.sigma * found.continuity.sigma;
    study.coverage +=
        0.5 * (std::abs(std::log(found.ratio.value / ratio)) < deviations * found.log_ratio_sigma) +
        0.5 * (std::abs(continuity_off) < deviations * found.continuity.sigma);
  }
  const double n = std::max(study.found, 1);
  study.off_px = std::sqrt(all.squares / (2.0 * std::max(all.seen, 1))) / pitch_mm;
  study.off_wales = study.off_px * pitch_mm / yarns().wale_mm;
  for (double* sum :
       {&study.ratio_error, &study.ratio_sigma, &study.continuity_error, &study.continuity_sigma}) {
    *sum = std::sqrt(*sum / n);
  }
  study.coverage /= n, study.seconds /= n;
  return study;
}

}  // namespace hada
