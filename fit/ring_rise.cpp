#include "fit/ring_rise.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr int reach = 12;        // columns on each side of an edge
constexpr int top_reach = 4;     // within which it is steepest
constexpr double foot = 0.1;     // of the steepest slope: less is no rise
constexpr int fewest_edges = 8;  // that a profile is the mean of
constexpr std::size_t fewest_rings = 8;
constexpr double clear = 4.0;          // deviations that the slope of the line must differ from 0
constexpr double most_share = 0.15;    // of a ring: more is not a rise at its beginning
constexpr double most_of_inner = 0.5;  // of the ring inside a boundary, that an onset may take
constexpr double unseen = 0.5;         // of the onset of a ring of which nothing is seen
const double even = std::sqrt(3.0), smooth = std::sqrt(5.0);  // onsets, in standard deviations

/// The mean brightness across all edges of a ring, each in its own place.
std::optional<std::vector<double>> profile_across(const RingChain& ring, const Unrolled& flat) {
  std::vector<double> sum(2 * reach + 1, 0.0), one(sum.size());
  int count = 0;
  for (const RingEdge& edge : ring) {
    const double at = (edge.rho - flat.first) / flat.step;
    const int from = int(at) - reach;
    if (from < 0 || from + 2 * reach + 1 >= flat.values.cols()) continue;
    const double u = at - int(at);
    bool known = true;
    for (int k = 0; k <= 2 * reach && known; ++k) {
      const double value = (1.0 - u) * double(flat.values(edge.sector, from + k)) +
                           u * double(flat.values(edge.sector, from + k + 1));
      known = std::isfinite(value);
      one[std::size_t(k)] = std::exp(value);
    }
    if (!known) continue;
    ++count;
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += one[k];
  }
  if (count < fewest_edges) return std::nullopt;
  for (double& value : sum) value /= count;
  return sum;
}

/// Variance of where a profile rises, around its steepest place, in columns squared; none if it
/// falls.
std::optional<double> variance_of_rise(const std::vector<double>& profile) {
  std::vector<double> slope(profile.size(), 0.0);
  for (std::size_t k = 1; k + 1 < profile.size(); ++k) slope[k] = profile[k + 1] - profile[k - 1];
  const auto top =
      std::max_element(slope.begin() + reach - top_reach, slope.begin() + reach + top_reach + 1);
  if (!(*top > 0.0)) return std::nullopt;
  auto from = top, to = top;
  while (from != slope.begin() && *(from - 1) > foot * *top) --from;
  while (to + 1 != slope.end() && *(to + 1) > foot * *top) ++to;
  double weight = 0.0, mean = 0.0, square = 0.0;
  for (auto it = from; it <= to; ++it) {
    const auto place = double(it - top);
    weight += *it;
    mean += *it * place;
    square += *it * place * place;
  }
  mean /= weight;
  return square / weight - mean * mean;
}

}  // namespace

RingRise ring_rise(const std::vector<RingChain>& rings, const std::vector<double>& radii,
                   const Unrolled& flat) {
  std::vector<double> squares, variances;  // of the width of a ring, of its rise
  for (std::size_t k = 0; k + 1 < radii.size(); ++k) {
    const auto profile = profile_across(rings[k], flat);
    const auto variance = profile ? variance_of_rise(*profile) : std::nullopt;
    if (!variance) continue;
    squares.push_back(std::pow((radii[k + 1] - radii[k]) / flat.step, 2));
    variances.push_back(*variance);
  }
  if (squares.size() < fewest_rings) return {};
  // The line of Theil and Sen: a crack or a false ring beside a boundary does not turn it.
  std::vector<double> slopes, rest;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (squares[i] != squares[j])
        slopes.push_back((variances[i] - variances[j]) / (squares[i] - squares[j]));
    }
  }
  if (slopes.empty()) return {};
  const double slope = median(slopes);
  for (std::size_t i = 0; i < squares.size(); ++i)
    rest.push_back(variances[i] - slope * squares[i]);
  const double level = median(rest);
  double mean = 0.0, spread = 0.0;
  for (const double square : squares) mean += square / double(squares.size());
  for (const double square : squares) spread += (square - mean) * (square - mean);
  for (double& value : rest) value = std::abs(value - level);
  const double sigma = 1.4826 * median(rest) / std::sqrt(spread);
  if (!(slope > clear * sigma)) return {};
  const double deviation = std::sqrt(slope), share = 0.5 * (even + smooth) * deviation;
  if (share > most_share) return {};
  const double by_shape = (smooth - even) / std::sqrt(12.0) * deviation;
  return {share, std::hypot(0.5 * share * sigma / slope, by_shape)};
}

RingOnset onset_of(const RingRise& rise, const std::vector<double>& radii) {
  RingOnset onset{std::vector<double>(radii.size(), 0.0), std::vector<double>(radii.size(), 0.0)};
  if (radii.size() < 2 || rise.share <= 0.0) return onset;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const bool last = k + 1 == radii.size();
    const double width = last ? radii[k] - radii[k - 1] : radii[k + 1] - radii[k];
    const double inner = k > 0 ? radii[k] - radii[k - 1] : radii[k];
    onset.before[k] = std::min(rise.share * width, most_of_inner * inner);  // radii keep rising
    onset.sigma[k] = last ? unseen * onset.before[k] : rise.sigma * width;
  }
  return onset;
}

}  // namespace hada
