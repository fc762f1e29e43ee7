#include "app/comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "app/overlap.h"
#include "core/error.h"
#include "io/json.h"

namespace hada {
namespace {

// The rings that hold something: of a small map, the first one holds the mean alone.
struct LogRings {
  std::vector<double> frequency, density;  // log10

  explicit LogRings(const Rings& rings) {
    for (std::size_t i = 0; i < rings.density.size(); ++i) {
      if (!(rings.density[i] > 0.0)) continue;
      frequency.push_back(rings.frequency[i]);
      density.push_back(std::log10(rings.density[i]));
    }
  }

  // Between ring middles; the nearest ring beyond the ends, -infinity where there is none.
  double at(double f) const {
    if (density.empty()) return -HUGE_VAL;
    const auto above = std::lower_bound(frequency.begin(), frequency.end(), f);
    const auto i = std::size_t(above - frequency.begin());
    if (i == 0) return density.front();
    if (i == frequency.size()) return density.back();
    const double share = (f - frequency[i - 1]) / (frequency[i] - frequency[i - 1]);
    return (1.0 - share) * density[i - 1] + share * density[i];
  }
};

std::size_t nearest_ring(const Rings& rings, double frequency) {
  const auto above = std::lower_bound(rings.frequency.begin(), rings.frequency.end(), frequency);
  const auto i = std::size_t(above - rings.frequency.begin());
  if (i == 0 || i == rings.frequency.size()) return i == 0 ? 0 : i - 1;
  return frequency - rings.frequency[i - 1] < rings.frequency[i] - frequency ? i - 1 : i;
}

// Over the rings of `a` that count, of difference(i, log10 of a, log10 of b).
template <class Difference>
double root_mean_square_over(const Rings& a, const Rings& b, const Difference& difference) {
  // What lies 60 dB under the strongest ring is the residue of tapers and noise in either map.
  const double strongest = std::max(*std::max_element(a.density.begin(), a.density.end()),
                                    *std::max_element(b.density.begin(), b.density.end()));
  const double floor = std::log10(1e-6 * strongest);
  const LogRings log_b(b);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < a.frequency.size(); ++i) {
    if (a.count[i] == 0 || a.frequency[i] > b.frequency.back()) continue;
    const double of_a = std::max(floor, std::log10(a.density[i]));
    const double of_b = std::max(floor, log_b.at(a.frequency[i]));
    if (of_a == floor && of_b == floor) continue;
    const double decibel = difference(i, of_a, of_b);
    if (!std::isfinite(decibel)) continue;
    sum += decibel * decibel;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / count);
}

}  // namespace

double spectral_distance_db(const Rings& a, const Rings& b) {
  return root_mean_square_over(
      a, b, [&](std::size_t, double of_a, double of_b) { return 10.0 * (of_a - of_b); });
}

double spectral_floor_db(const Rings& a, const Rings& b) {
  constexpr double per_neper = 4.342944819;  // decibel of power
  return root_mean_square_over(a, b, [&](std::size_t i, double, double) {
    const std::size_t j = nearest_ring(b, a.frequency[i]);
    return per_neper * std::hypot(a.sigma[i] / a.density[i], b.sigma[j] / b.density[j]);
  });
}

std::vector<double> light_errors(const std::vector<Light>& found, const std::vector<Light>& truth) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < std::min(found.size(), truth.size()); ++i) {
    angles.push_back(std::atan2(found[i].direction.cross(truth[i].direction).norm(),
                                found[i].direction.dot(truth[i].direction)));
  }
  return angles;
}

Comparison compare(const Surface& first, const Surface& second) {
  if (first.extent.unit != second.extent.unit) {
    throw Error("one surface is in mm and the other in px; give both a pitch (--pitch MM)");
  }
  if (first.has_height() != second.has_height()) {
    throw Error(
        "only one of the two has a height; compare surfaces with surfaces and pictures "
        "with pictures");
  }
  Comparison comparison;
  comparison.overlap = overlap(first, second);
  comparison.first = measure(first);
  comparison.second = measure(second);
  comparison.spectral_distance_db =
      spectral_distance_db(comparison.first.rings, comparison.second.rings);
  comparison.spectral_floor_db = spectral_floor_db(comparison.first.rings, comparison.second.rings);
  return comparison;
}

std::string comparison_text(const Comparison& c) {
  Json json = {{"hada", "compare/1"}, {"unit", name_of(c.first.extent.unit)}};
  if (c.overlap) {
    Json& overlap = json["overlap"];
    overlap["pixels"] = c.overlap->pixels;
    overlap["height_rmse"] = c.overlap->height_rmse;
    overlap["height_std"] = c.overlap->height_std;
    if (c.overlap->has_normals) {
      constexpr double degree = std::numbers::pi / 180.0;
      overlap["normal_mean_deg"] = c.overlap->normal_mean / degree;
      overlap["normal_median_deg"] = c.overlap->normal_median / degree;
    }
  }
  json["spectral_distance_db"] = c.spectral_distance_db;
  json["spectral_floor_db"] = c.spectral_floor_db;
  const auto add = [&](const char* key, Roughness RoughnessEstimate::*which) {
    json[key] = {Json::parse(roughness_text(c.first.roughness.*which)),
                 Json::parse(roughness_text(c.second.roughness.*which))};
  };
  add("roughness", &RoughnessEstimate::value);
  add("roughness_sigma", &RoughnessEstimate::sigma);
  return json.dump(1) + "\n";
}

}  // namespace hada
