#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/knit_study.h"
#include "core/quantile.h"
#include "core/random.h"
#include "fit/knit.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "measure/lattice.h"
#include "synth/knit_loops.h"

namespace hada {
namespace {

Knit<> random_knit(Seed seed) {
  const auto between = [&](int key, double low, double high) {
    return low + (high - low) * uniform(seed, key);
  };
  Knit<> knit;
  knit.wale_mm = between(1, 1.5, 2.4);
  knit.course_mm = knit.wale_mm * between(2, 0.7, 0.9);
  knit.rotation_rad = between(3, -0.1, 0.1);
  knit.skew_rad = between(4, -0.04, 0.04);
  knit.wale_gradient_per_mm = between(5, -8e-4, 8e-4);
  knit.course_gradient_per_mm = between(6, -8e-4, 8e-4);
  knit.yarn_radius_mm = knit.wale_mm * between(7, 0.15, 0.19);
  knit.loop_depth_mm = 0.8 * knit.yarn_radius_mm;
  knit.colour_repeat =
      uniform(seed, 8) < 0.5 ? std::vector<double>{0.0, 1.0} : std::vector<double>{0.0, 1.0, 1.0};
  knit.yarns = {{0.15, 0.25, 0.4}, {0.7, 0.6, 0.3}};
  return knit;
}

// Seen twice as fine as the picture, shaded, with uneven stitches, noise and eight bits.
Surface seen_knit(const Knit<>& knit, const Extent& extent, Seed seed) {
  const Extent fine{2 * extent.rows, 2 * extent.cols, 0.5 * extent.pitch, extent.unit};
  const auto maps = knit_maps(knit, fine, seed, {.jitter_mm = 0.01 * knit.wale_mm});
  const Eigen::Vector3f light = Eigen::Vector3f(-0.2f, 0.3f, 0.9f).normalized();
  Surface seen;
  seen.extent = extent;
  seen.mask = full_mask(extent);
  seen.albedo = Image(extent.rows, extent.cols, 3);
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      const int course = maps.course(row, col);
      if (course < 0) continue;
      const auto& yarn = knit.yarns[std::size_t(knit.colour_repeat[std::size_t(course)])];
      const float shade = 0.3f + 0.7f * std::max(0.0f, maps.normals(row, col).dot(light));
      const Eigen::Vector3d colour(yarn.red, yarn.green, yarn.blue);
      for (std::size_t c = 0; c < 3; ++c) {
        seen.albedo.planes[c](row / 2, col / 2) += 0.25f * shade * float(colour[int(c)]);
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < seen.albedo.planes[c].size(); ++i) {
      const double noisy =
          seen.albedo.planes[c][i] + 0.02 * gaussian(seed + 1, std::int64_t(i), int(c));
      seen.albedo.planes[c][i] = float(std::round(255.0 * std::clamp(noisy, 0.0, 1.0)) / 255.0);
    }
  }
  return seen;
}

}  // namespace

LatticeStudy study_lattice(int pictures) {
  std::vector<double> wale, course;
  for (int i = 0; i < pictures; ++i) {
    const Knit<> truth = random_knit(Seed(100 + i));
    const Extent extent{480, 600, truth.wale_mm / 26.0, Unit::mm};
    const auto found = fit_knit(seen_knit(truth, extent, Seed(200 + i))).material;
    wale.push_back(std::abs(found.wale_mm / truth.wale_mm - 1.0));
    course.push_back(std::abs(found.course_mm / truth.course_mm - 1.0));
  }
  return {*std::max_element(wale.begin(), wale.end()),
          *std::max_element(course.begin(), course.end()), median(wale), median(course)};
}

std::vector<RenderedKnit> score_rendered_knits(const std::filesystem::path& folder) {
  std::vector<RenderedKnit> scores;
  const Json truth = read_plain_json(folder / "truth" / "truth.json");
  for (const auto& [name, knit] : truth.at("knits").items()) {
    const auto number = [&, &values = knit](const char* key) {
      return values.at(key).get<double>();
    };
    const auto found =
        fit_knit(read_surface(folder / (name + ".png"), number("pixel_mm"))).material;
    const auto error = [&](double value, const char* key) {
      return std::abs(value / number(key) - 1.0);
    };
    RenderedKnit score;
    score.name = name;
    score.wale = error(found.wale_mm, "wale_mm");
    score.course = error(found.course_mm, "course_mm");
    score.radius = error(found.yarn_radius_mm, "yarn_radius_mm");
    score.gradient = std::max(error(found.wale_gradient_per_mm, "grad_wale_per_mm"),
                              error(found.course_gradient_per_mm, "grad_course_per_mm"));
    score.rotation_deg =
        std::abs(found.rotation_rad * 180.0 / std::numbers::pi - number("rot_deg"));
    // Ours are sorted from dark to bright.
    const auto& repeat = knit.at("course_colour_repeat");
    const auto& colours = knit.at("yarn_rgb_linear");
    std::vector<double> order;
    const auto brightness = [&](int yarn) {
      double sum = 0.0;
      for (const auto& part : colours.at(std::size_t(yarn))) sum += part.get<double>();
      return sum;
    };
    for (const auto& yarn : repeat) {
      double darker = 0.0;
      for (int other = 0; other < int(colours.size()); ++other) {
        darker += brightness(other) < brightness(yarn.get<int>());
      }
      order.push_back(darker);
    }
    score.repeat = order == found.colour_repeat;
    scores.push_back(score);
  }
  return scores;
}

std::array<double, 2> count_hand_knit(const std::filesystem::path& picture) {
  const Surface surface = read_surface(picture);
  const auto found = fit_knit(surface).material;
  return {surface.extent.cols / found.wale_mm, surface.extent.cols / found.course_mm};
}

double jersey_peak_error(const std::filesystem::path& picture) {
  const Surface surface = read_surface(picture);
  const auto peaks = spectral_peaks(
      power_spectrum(luminance(surface.albedo), surface.mask, surface.extent, {.taper = 1.0}));
  double worst = 0.0;
  for (const Eigen::Vector2d& wanted : {Eigen::Vector2d(32.0, 64.0), Eigen::Vector2d(64.0, 0.0)}) {
    double nearest = HUGE_VAL;
    for (const auto& peak : peaks) {
      nearest = std::min(nearest, (peak.frequency * surface.extent.width() - wanted).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace hada
