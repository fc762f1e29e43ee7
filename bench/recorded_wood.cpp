#include "bench/recorded_wood.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/wood.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "measure/ring_profile.h"

namespace hada {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<double> smooth(const std::vector<double>& values, double sigma) {
  std::vector<double> result;
  const int reach = int(3.0 * sigma), count = int(values.size());
  for (int i = 0; i < count; ++i) {
    double sum = 0.0, weight = 0.0;
    for (int k = std::max(0, i - reach); k <= std::min(count - 1, i + reach); ++k) {
      const double w = std::exp(-0.5 * (k - i) * (k - i) / (sigma * sigma));
      sum += w * values[std::size_t(k)];
      weight += w;
    }
    result.push_back(sum / weight);
  }
  return result;
}

constexpr int degrees = 360;

/// A ring of CS-TRD: its distance from the centre at every degree.
using Polar = std::array<double, degrees>;

Polar polar_of(const Json& shape, double row, double col) {
  Polar radii{};
  for (const Json& point : shape["points"]) {
    const double down = point[1].get<double>() - row, right = point[0].get<double>() - col;
    const long degree = std::lround(std::atan2(down, right) * 180.0 / M_PI);
    radii[std::size_t((degree + degrees) % degrees)] = std::hypot(down, right);
  }
  return radii;
}

/// Whether `ring` lies between its neighbours by a formula: where CS-TRD sees no edge, its share of
/// the way from one to the other is a straight line over the angle
/// (`generate_node_list_between_two_support_chains_and_two_radial_distances` of its source).
bool is_interpolated(const Polar& inner, const Polar& ring, const Polar& outer) {
  const auto share = [&](int k) {
    const auto at = std::size_t(k % degrees);
    return (ring[at] - inner[at]) / (outer[at] - inner[at]);
  };
  int straight = 0;
  for (int k = 0; k < degrees; ++k) {
    if (std::abs(share(k) - 2.0 * share(k + 1) + share(k + 2)) < 1e-9) ++straight;
  }
  return straight > 9 * degrees / 10;
}

}  // namespace

DiscScore score_disc(const std::filesystem::path& folder) {
  const Json truth = Json::parse(std::ifstream(folder / "F02b_detected_by_cs_trd.json"));
  const auto surface = read_surface(folder / "F02b.png");
  const int before = threads();
  set_threads(1);
  const std::clock_t start = std::clock();
  const auto wood = fit_wood(surface, {.view = WoodView::end_grain}).material;
  DiscScore score;
  score.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  set_threads(before);
  std::vector<Polar> polars;
  for (const Json& shape : truth["shapes"])
    polars.push_back(
        polar_of(shape, truth["center"][0].get<double>(), truth["center"][1].get<double>()));
  const auto by_size = [](const Polar& a, const Polar& b) { return a[0] < b[0]; };
  std::sort(polars.begin(), polars.end(), by_size);
  const Eigen::Vector2d pith(wood.pith_mm[0], wood.pith_mm[1]);
  const auto place = [&](const Json& point) {
    return surface.extent.place(point[1].get<double>() - 0.5, point[0].get<double>() - 0.5);
  };
  std::vector<double> differences;
  double farthest = 0.0, nearest = HUGE_VAL;
  for (const Json& shape : truth["shapes"]) {
    std::vector<double> rho;
    Eigen::Vector2d middle(0.0, 0.0);
    double mean = 0.0;
    for (const Json& point : shape["points"]) middle += place(point);
    middle /= double(shape["points"].size());
    for (const Json& point : shape["points"]) {
      const Eigen::Vector2d arm = place(point) - pith;
      rho.push_back(effective_radius(wood.lobes, arm.norm(), std::atan2(arm.y(), arm.x())));
      mean += (place(point) - middle).norm() / double(shape["points"].size());
    }
    farthest = std::max(farthest, mean);
    if (mean < nearest) {
      nearest = mean;
      score.pith_share = (middle - pith).norm();
    }
    if (mean < 10.0) continue;  // the pith itself
    ++score.rings;
    const Polar polar =
        polar_of(shape, truth["center"][0].get<double>(), truth["center"][1].get<double>());
    const auto own = std::lower_bound(polars.begin(), polars.end(), polar, by_size);
    const bool followed = own == polars.begin() || own + 1 == polars.end() ||
                          !is_interpolated(*(own - 1), polar, *(own + 1));
    if (followed) ++score.followed;
    double best = HUGE_VAL, difference = 0.0;
    for (const double radius : wood.ring_radii_mm) {
      double distance = 0.0, sum = 0.0;
      for (const double value : rho) {
        distance += std::abs(value - radius) / double(rho.size());
        sum += (value - radius) / double(rho.size());
      }
      if (distance >= best) continue;
      best = distance;
      difference = sum;
    }
    if (best >= 6.0) continue;
    ++score.found;
    if (followed) ++score.followed_found;
    differences.push_back(std::abs(difference));
  }
  score.pith_share /= farthest;
  score.radius_px = differences.empty() ? HUGE_VAL : median(differences);
  return score;
}

ProfileScore score_profiles(const std::filesystem::path& folder) {
  std::ifstream densities(folder / "density.csv"), years(folder / "years.csv");
  std::string line;
  std::getline(densities, line);
  std::vector<std::vector<double>> profiles(cells_of(line).size());
  while (std::getline(densities, line)) {
    const auto cells = cells_of(line);
    for (std::size_t k = 0; k < std::min(cells.size(), profiles.size()); ++k) {
      if (!cells[k].empty() && std::isdigit(static_cast<unsigned char>(cells[k][0])))
        profiles[k].push_back(-std::stod(cells[k]));  // dense is dark
    }
  }
  ProfileScore score;
  std::getline(years, line);
  for (std::size_t k = 0; k < profiles.size() && std::getline(years, line); ++k) {
    const auto cells = cells_of(line);
    if (cells.size() < 3 || cells[1] == "NA") continue;
    const int span = std::stoi(cells[2]) - std::stoi(cells[1]) + 1;
    const auto found = ring_boundaries(smooth(profiles[k], 3.0), {.noise = 0.02});
    ++score.dated;
    if (std::abs(int(found.size()) - span) <= 1) ++score.right;
  }
  return score;
}

}  // namespace hada
