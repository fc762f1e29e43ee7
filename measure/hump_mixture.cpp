#include "measure/hump_mixture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "measure/half_plane.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double patch_growth = 0.04;         // of the frequency, as a logarithm
constexpr double patch_angle = pi / 45.0;     // 4 degrees
constexpr double least_waves = 1.2;           // over the shorter side; with fewer the taper decides
constexpr double most_of_sampling = 0.45;     // cycles per pixel
constexpr double longest_share = 1.0 / 0.75;  // wavelength of a hump over the longer side
constexpr double faintest = 1e-9;  // of the highest power: below it lies what a taper lets through
constexpr int ground_count = 3;
constexpr int most_rounds = 60;
constexpr double longest_step = 0.7;  // of a logarithm or an angle, where the quadratic still holds
constexpr double enough = 1e-3;       // of the deviance, far below what tells mixtures apart

double log_frequency(double fx, double fy) {
  return 0.5 * std::log(fx * fx + fy * fy);
}

/// The parameters of a mixture in a row: those of the humps, then those of the ground.
Eigen::VectorXd packed(const HumpMixture& mixture) {
  Eigen::VectorXd x(SpectralHump::parameter_count * int(mixture.humps.size()) + ground_count);
  Eigen::Index at = 0;
  for (const SpectralHump& hump : mixture.humps) {
    for (const double value : hump.parameters()) x[at++] = value;
  }
  x.tail<ground_count>() << mixture.log_floor, mixture.log_fall, mixture.steepness;
  return x;
}

HumpMixture unpacked(const Eigen::VectorXd& x, const HumpMixture& like, const HumpBounds& bounds) {
  HumpMixture mixture = like;
  Eigen::Index at = 0;
  for (SpectralHump& hump : mixture.humps) {
    SpectralHump::Parameters values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = std::clamp(x[at++], bounds.low[i], bounds.high[i]);
    hump = hump.with(values);
  }
  mixture.log_floor = x[at++];
  mixture.log_fall = x[at++];
  mixture.steepness = std::clamp(x[at], 0.5, 5.0);  // of surfaces: beyond lies nothing that is met
  return mixture;
}

double deviance(const HumpMixture& mixture, const std::vector<SpectralPatch>& patches) {
  const MixtureDensity density_at(mixture);
  double sum = 0.0;
  for (const SpectralPatch& patch : patches) {
    const double density = density_at(patch.fx, patch.fy);
    sum += patch.count * (patch.power / density + std::log(density));
  }
  return sum;
}

/// Slope of minus the deviance and its expected curvature.
struct Score {
  Eigen::VectorXd slope;
  Eigen::MatrixXd information;
};

Score score_of(const HumpMixture& mixture, const std::vector<SpectralPatch>& patches) {
  const auto count =
      Eigen::Index(SpectralHump::parameter_count * int(mixture.humps.size()) + ground_count);
  const std::vector<HumpDensity> humps(mixture.humps.begin(), mixture.humps.end());
  const SpectralGround ground = mixture.ground();
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(count);
  Eigen::MatrixXd columns(count, Eigen::Index(patches.size()));  // derivatives of log density
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const SpectralPatch& patch = patches[i];
    auto column = columns.col(Eigen::Index(i));
    const double log_f = log_frequency(patch.fx, patch.fy);
    const double fall = ground.fall(log_f);
    double density = ground.floor + fall;
    Eigen::Index at = 0;
    for (const HumpDensity& hump : humps) {
      SpectralHump::Parameters derivatives;
      const double part = hump(patch.fx, patch.fy, derivatives);
      for (const double derivative : derivatives) column[at++] = part * derivative;
      density += part;
    }
    column.tail<ground_count>() << ground.floor, fall, -fall * log_f;
    column /= density;
    slope += patch.count * (patch.power / density - 1.0) * column;
    column *= std::sqrt(patch.count);
  }
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
  information.selfadjointView<Eigen::Lower>().rankUpdate(columns);
  information = Eigen::MatrixXd(information.selfadjointView<Eigen::Lower>());
  return {slope, information};
}

}  // namespace

SpectralPatches patches_of(const Spectrum& spectrum) {
  const Extent& extent = spectrum.extent;
  const double least = least_waves / std::min(extent.width(), extent.height());
  const double most = most_of_sampling / extent.pitch;
  std::map<std::pair<int, int>, SpectralPatch> patches;
  visit_half_plane(spectrum, most, most, [&](int row, int col, double fx, double fy, int) {
    const double f = std::hypot(fx, fy), power = spectrum.power(row, col);
    if (f < least || f > most || (fx == 0.0 && fy < 0.0) || !(power > 0.0)) return;
    SpectralPatch& patch = patches[{int(std::floor(std::log(f) / patch_growth)),
                                    int(std::floor(std::atan2(fy, fx) / patch_angle))}];
    patch.fx += fx;
    patch.fy += fy;
    patch.power += power;
    patch.count += 1.0;
  });
  SpectralPatches result{{}, extent, spectrum.independence};
  double highest = 0.0;
  for (auto& [place, patch] : patches) {
    result.all.push_back(
        {patch.fx / patch.count, patch.fy / patch.count, patch.power / patch.count, patch.count});
    highest = std::max(highest, result.all.back().power);
  }
  for (SpectralPatch& patch : result.all) patch.power += faintest * highest;
  return result;
}

MixtureDensity::MixtureDensity(const HumpMixture& mixture)
    : ground_(mixture.ground()), humps_(mixture.humps.begin(), mixture.humps.end()) {}

double MixtureDensity::operator()(double fx, double fy) const {
  double sum = ground_(log_frequency(fx, fy));
  for (const HumpDensity& hump : humps_) sum += hump(fx, fy);
  return sum;
}

double prominence(const SpectralHump& hump, const HumpMixture& mixture,
                  const std::vector<SpectralPatch>& patches) {
  const HumpDensity own(hump);
  const MixtureDensity all(mixture);
  double power = 0.0, standing_out = 0.0;
  for (const SpectralPatch& patch : patches) {
    const double density = own(patch.fx, patch.fy);
    power += patch.count * density;
    standing_out += patch.count * density * density / all(patch.fx, patch.fy);
  }
  return power > 0.0 ? standing_out / power : 0.0;
}

HumpMixture without_flanks(HumpMixture mixture, const std::vector<SpectralPatch>& patches) {
  constexpr double least_prominence = 0.5;  // below it more of the waves there are those of others
  while (!mixture.humps.empty()) {
    std::vector<double> all;
    for (const SpectralHump& hump : mixture.humps)
      all.push_back(prominence(hump, mixture, patches));
    const auto least = std::min_element(all.begin(), all.end());
    if (!(*least < least_prominence)) break;
    mixture.humps.erase(mixture.humps.begin() + (least - all.begin()));
  }
  return mixture;
}

HumpBounds hump_bounds(const Extent& extent) {
  const double longest = longest_share * std::max(extent.width(), extent.height());
  constexpr double any = 1e3;  // a logarithm or an angle that nothing reaches
  return {{-any, -std::log(longest), std::log(0.05), std::log(0.05), -any},
          {any, std::log(0.5 / extent.pitch), std::log(0.8), std::log(2.0), any}};
}

HumpFit fitted(const HumpMixture& start, const std::vector<SpectralPatch>& patches,
               const HumpBounds& bounds) {
  HumpFit best{start, deviance(start, patches)};
  double damping = 1e-2;
  for (int round = 0; round < most_rounds; ++round) {
    const Score score = score_of(best.mixture, patches);
    const Eigen::VectorXd x = packed(best.mixture);
    const double before = best.deviance;
    for (int tries = 0; tries < 8 && best.deviance == before; ++tries) {
      Eigen::MatrixXd damped = score.information;
      damped.diagonal().array() += damping * (score.information.diagonal().array() + 1e-6);
      const Eigen::VectorXd step =
          damped.ldlt().solve(score.slope).cwiseMax(-longest_step).cwiseMin(longest_step);
      const HumpMixture tried = unpacked(x + step, best.mixture, bounds);
      const double deviance_there = deviance(tried, patches);
      if (deviance_there < before) {
        best = {tried, deviance_there};
        damping = std::max(damping / 4.0, 1e-8);
      } else {
        damping *= 6.0;
      }
    }
    if (!(before - best.deviance > enough)) break;
  }
  return best;
}

}  // namespace hada
