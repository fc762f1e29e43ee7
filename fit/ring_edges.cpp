#include "fit/ring_edges.h"

#include <algorithm>
#include <cmath>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr double faint_share = 0.25;    // of the strong slopes nearby
constexpr double above_noise = 3.0;     // deviations
constexpr std::ptrdiff_t nearby = 6;    // slopes on each side
constexpr double reach_share = 0.2;     // of the distance between rings
constexpr double least_reach_px = 2.0;  // an edge may move from sector to sector

/// Those of `values` that are nearest to number `k`.
std::vector<double> values_around(const std::vector<double>& values, std::size_t k) {
  const auto count = std::ptrdiff_t(values.size()), at = std::ptrdiff_t(k);
  const auto from = std::clamp<std::ptrdiff_t>(at - nearby, 0, count);
  const auto to = std::clamp<std::ptrdiff_t>(at + nearby + 1, from, count);
  return {values.begin() + from, values.begin() + to};
}

std::vector<RingEdge> edges_of(const Unrolled& flat, int sector, double pitch, double blur_px) {
  const double step_px = flat.step / pitch;
  const auto slope = slopes_along(flat.values.row(sector), step_px, blur_px);
  std::vector<RingEdge> edges;
  std::vector<double> falling, rising;
  for (std::size_t i = 1; i + 1 < slope.size(); ++i) {
    const double here = slope[i], before = slope[i - 1], after = slope[i + 1];
    if (here < 0.0 && here <= before && here < after) falling.push_back(-here);
    if (!(here >= before) || !(here > after)) continue;  // not a maximum, or not finite
    if (here <= 0.0) continue;
    const double curvature = before - 2.0 * here + after;
    const double shift = curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
    edges.push_back({sector, flat.rho(double(i) + shift), here});
    rising.push_back(here);
  }
  std::vector<RingEdge> clear;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    // Latewood darkens slowly, so that what falls steeply is mostly noise.
    const auto noisy = values_around(falling, k);
    const double noise = noisy.empty() ? 0.0 : median(noisy) / 1.5;
    const double strong = quantile(values_around(rising, k), 0.9);
    const double least =
        std::max(faint_share * strong, std::min(above_noise * noise, 0.5 * strong));
    if (edges[k].strength >= least) clear.push_back(edges[k]);
  }
  return clear;
}

/// Half the way to the neighbours that are further than a few pixels: how far rings lie apart.
double usual_distance(const std::vector<std::vector<RingEdge>>& edges, double pitch) {
  std::vector<double> distances;
  for (const auto& sector : edges) {
    for (std::size_t i = 1; i < sector.size(); ++i)
      distances.push_back(sector[i].rho - sector[i - 1].rho);
  }
  return distances.empty() ? 10.0 * pitch : median(distances);
}

int nearest(const std::vector<RingEdge>& edges, double rho) {
  const auto after =
      std::lower_bound(edges.begin(), edges.end(), rho,
                       [](const RingEdge& e, double value) { return e.rho < value; });
  int best = -1;
  double least = HUGE_VAL;
  for (int k = int(after - edges.begin()) - 1; k <= int(after - edges.begin()); ++k) {
    if (k < 0 || k >= int(edges.size())) continue;
    const double distance = std::abs(edges[std::size_t(k)].rho - rho);
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

}  // namespace

std::vector<double> slopes_along(std::span<const float> values, double step_px, double blur_px) {
  const int half = int(std::ceil(3.0 * blur_px / step_px));
  std::vector<double> kernel;
  double norm = 0.0;
  for (int k = -half; k <= half; ++k) {
    const double t = k * step_px / blur_px;
    kernel.push_back(k * std::exp(-0.5 * t * t));
    norm += kernel.back() * k * step_px;
  }
  std::vector<double> slopes(values.size(), std::nan(""));
  for (int i = half; i + half < int(values.size()); ++i) {
    double sum = 0.0;
    for (int k = -half; k <= half; ++k)
      sum += kernel[std::size_t(k + half)] * double(values[std::size_t(i + k)]);
    slopes[std::size_t(i)] = sum / norm;
  }
  return slopes;
}

double middle_of_rise(std::span<const float> values, double index, double step_px) {
  constexpr double reach_px = 4.0;  // on both sides, of the dark and of the light
  const int middle = int(std::lround(index));
  const int reach = int(std::lround(reach_px / step_px));
  if (middle < reach || middle + reach >= int(values.size())) return index;
  const auto at = [&](int i) { return double(values[std::size_t(i)]); };
  int dark = middle, light = middle;
  while (dark > middle - reach && !(at(dark - 1) > at(dark))) --dark;
  while (light < middle + reach && !(at(light + 1) < at(light))) ++light;
  // A pixel mixes light, what is read between pixels mixes its logarithm: half way between both.
  const double mixed = std::log(0.5 * (std::exp(at(dark)) + std::exp(at(light))));
  const double half = 0.5 * (mixed + 0.5 * (at(dark) + at(light)));
  for (int i = dark; i < light; ++i) {
    if (at(i) <= half && at(i + 1) > half) return i + (half - at(i)) / (at(i + 1) - at(i));
  }
  return index;
}

RingEdge middle_of_rise(const RingEdge& edge, const Unrolled& flat, double pitch) {
  RingEdge moved = edge;
  const double index = (edge.rho - flat.first) / flat.step;
  moved.rho = flat.rho(middle_of_rise(flat.values.row(edge.sector), index, flat.step / pitch));
  return moved;
}

std::vector<std::vector<RingEdge>> ring_edges(const Unrolled& flat, double pitch, double blur_px) {
  std::vector<std::vector<RingEdge>> edges;
  for (int s = 0; s < flat.values.rows(); ++s) edges.push_back(edges_of(flat, s, pitch, blur_px));
  return edges;
}

std::vector<RingChain> ring_chains(const std::vector<std::vector<RingEdge>>& edges,
                                   const Unrolled& flat, double pitch, int fewest) {
  const double reach = std::max(least_reach_px * pitch, reach_share * usual_distance(edges, pitch));
  const int sectors = int(edges.size());
  std::vector<std::vector<int>> chain_of;
  for (const auto& sector : edges) chain_of.emplace_back(sector.size(), -1);
  std::vector<RingChain> chains;
  for (int s = 0; s < sectors; ++s) {
    for (std::size_t i = 0; i < edges[std::size_t(s)].size(); ++i) {
      const RingEdge& edge = edges[std::size_t(s)][i];
      int& mine = chain_of[std::size_t(s)][i];
      if (mine < 0) {
        mine = int(chains.size());
        chains.emplace_back(1, edge);
      }
      for (int ahead = 1; ahead <= 2 && s + ahead < sectors; ++ahead) {
        const auto& next = edges[std::size_t(s + ahead)];
        const int k = nearest(next, edge.rho);
        if (k < 0 || std::abs(next[std::size_t(k)].rho - edge.rho) > reach) continue;
        const int back = nearest(edges[std::size_t(s)], next[std::size_t(k)].rho);
        int& theirs = chain_of[std::size_t(s + ahead)][std::size_t(k)];
        if (back != int(i) || theirs >= 0) continue;
        theirs = mine;
        chains[std::size_t(mine)].push_back(next[std::size_t(k)]);
        break;
      }
    }
  }
  std::erase_if(chains, [&](const RingChain& chain) {
    double seen = 0.0;
    for (const RingEdge& edge : chain) seen += 1.0 / (2.0 * flat.joined_at(edge.rho) + 1.0);
    return seen < fewest - 1e-9;
  });
  return chains;
}

}  // namespace hada
