#include "fit/ring_radii.h"

#include <algorithm>
#include <cmath>

#include "core/quantile.h"
#include "measure/ring_profile.h"

namespace hada {
namespace {

constexpr double blur_px = 1.0;       // of the slopes that are summed over sectors
constexpr double small_rise = 0.08;   // of the spread of the profile: noise
constexpr double smallest_px = 4.0;   // radius of a ring: below, it is the pith itself
constexpr std::size_t cut_part = 10;  // of the sectors, one in so many is cut at each end
constexpr int nearest_beside = 2, farthest_beside = 6;  // sectors, that say where a ring should be
constexpr double fewest_beside = 24.0;                  // sectors that a ring is judged by
constexpr double clear_of_noise = 5.0;                  // deviations of a mean slope
constexpr double least_way = 0.5;                       // around the pith, of a ring that wanders

/// The mean slope over all sectors, column by column; the extreme ones are left out.
std::vector<double> mean_slopes(const Unrolled& flat, double pitch) {
  const int cols = flat.values.cols();
  std::vector<std::vector<double>> seen{std::size_t(cols)};
  for (int s = 0; s < flat.values.rows(); ++s) {
    const auto slopes = slopes_along(flat.values.row(s), flat.step / pitch, blur_px);
    for (std::size_t col = 0; col < std::size_t(cols); ++col) {
      if (std::isfinite(slopes[col])) seen[col].push_back(slopes[col]);
    }
  }
  std::vector<double> mean(std::size_t(cols), 0.0);
  for (std::size_t col = 0; col < std::size_t(cols); ++col) {
    auto& values = seen[col];
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const std::size_t cut = values.size() / cut_part;
    double sum = 0.0;
    for (std::size_t i = cut; i < values.size() - cut; ++i) sum += values[i];
    mean[col] = sum / double(values.size() - 2 * cut);
  }
  return mean;
}

const RingEdge* nearest_within(const std::vector<RingEdge>& edges, double rho, double reach) {
  const RingEdge* best = nullptr;
  for (const RingEdge& edge : edges) {
    const double distance = std::abs(edge.rho - rho);
    if (distance >= reach) continue;
    reach = distance;
    best = &edge;
  }
  return best;
}

}  // namespace

std::vector<double> ring_radii(const Unrolled& flat, double pitch) {
  auto profile = mean_slopes(flat, pitch);
  double sum = 0.0;
  for (double& value : profile) value = sum += value * flat.step / pitch;
  const double spread = quantile(profile, 0.95) - quantile(profile, 0.05);
  std::vector<double> radii;
  for (const auto& boundary : ring_boundaries(profile, {.noise = small_rise * spread})) {
    const double rho = flat.rho(boundary.index);
    if (rho > smallest_px * pitch) radii.push_back(rho);
  }
  return radii;
}

std::vector<RingChain> edges_of_rings(const std::vector<double>& radii,
                                      const std::vector<std::vector<RingEdge>>& edges,
                                      const Unrolled& flat, double reach, double pitch) {
  std::vector<RingChain> rings(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const double inward = k > 0 ? 0.4 * (radii[k] - radii[k - 1]) : reach;
    const double outward = k + 1 < radii.size() ? 0.4 * (radii[k + 1] - radii[k]) : reach;
    const double most = std::min({reach, inward, outward});
    for (const auto& sector : edges) {
      if (const RingEdge* edge = nearest_within(sector, radii[k], most))
        rings[k].push_back(middle_of_rise(*edge, flat, pitch));
    }
  }
  return rings;
}

double radius_of(const RingChain& ring) {
  std::vector<double> radii;
  for (const RingEdge& edge : ring) radii.push_back(edge.rho);
  return median(std::move(radii));
}

std::vector<RingChain> wandering_rings(const std::vector<RingChain>& rings,
                                       const std::vector<RingChain>& chains, const Unrolled& flat,
                                       double reach, double pitch) {
  std::vector<double> radii, of_chain;
  for (const RingChain& ring : rings) radii.push_back(radius_of(ring));
  for (const RingChain& chain : chains) of_chain.push_back(radius_of(chain));
  std::vector<RingChain> found;
  for (std::size_t k = 1; k < radii.size(); ++k) {
    std::vector<const RingChain*> between;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (of_chain[c] > radii[k - 1] + reach && of_chain[c] < radii[k] - reach)
        between.push_back(&chains[c]);
    }
    std::stable_sort(between.begin(), between.end(),
                     [](const auto* a, const auto* b) { return a->size() > b->size(); });
    std::vector<bool> taken(flat.theta.size(), false);  // a ring passes a sector once
    RingChain ring;
    for (const RingChain* chain : between) {
      if (std::any_of(chain->begin(), chain->end(),
                      [&](const RingEdge& edge) { return taken[std::size_t(edge.sector)]; }))
        continue;
      for (const RingEdge& edge : *chain) {
        taken[std::size_t(edge.sector)] = true;
        ring.push_back(middle_of_rise(edge, flat, pitch));
      }
    }
    if (ring.empty()) continue;
    if (double(ring.size()) >= least_way * sectors_at(flat, radius_of(ring)))
      found.push_back(std::move(ring));
  }
  return found;
}

bool stands_out(const RingChain& ring, const Unrolled& flat, double pitch) {
  const double step_px = flat.step / pitch;
  const auto reach = std::ptrdiff_t(std::ceil(4.0 * blur_px / step_px));  // of what a slope sees
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (int s = 0; s < flat.values.rows(); ++s) {
    std::vector<double> beside;
    for (const RingEdge& edge : ring) {
      int apart = std::abs(edge.sector - s);
      if (flat.whole_turn) apart = std::min(apart, flat.values.rows() - apart);
      const int own = 2 * flat.joined_at(edge.rho);  // sectors that see a part of this one
      if (apart >= own + nearest_beside && apart <= own + farthest_beside)
        beside.push_back(edge.rho);
    }
    if (beside.empty()) continue;
    const auto col =
        std::ptrdiff_t(std::lround((median(std::move(beside)) - flat.first) / flat.step));
    const auto row = flat.values.row(s);
    if (col < reach || col + reach >= std::ptrdiff_t(row.size())) continue;
    const auto near = row.subspan(std::size_t(col - reach), std::size_t(2 * reach + 1));
    const double slope = slopes_along(near, step_px, blur_px)[std::size_t(reach)];
    if (!std::isfinite(slope)) continue;
    count += 1.0;
    sum += slope;
    squares += slope * slope;
  }
  if (count < fewest_beside) return true;
  const double mean = sum / count;
  const double variance = std::max(squares / count - mean * mean, 0.0);
  return mean > clear_of_noise * std::sqrt(variance / count);
}

int sectors_at(const Unrolled& flat, double rho) {
  const int col = int(std::lround((rho - flat.first) / flat.step));
  int count = 0;
  for (int s = 0; s < flat.values.rows(); ++s) {
    if (flat.values.contains(s, col) && std::isfinite(flat.values(s, col))) ++count;
  }
  return count;
}

}  // namespace hada
