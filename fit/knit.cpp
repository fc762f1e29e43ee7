#include "fit/knit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/LU>

#include "core/error.h"
#include "fit/knit_lattice.h"
#include "fit/knit_stitch.h"
#include "measure/lattice.h"

namespace hada {
namespace {

// Of a course over a wale; plain knit is usually 0.6 to 1.
constexpr double lowest_aspect = 0.4, highest_aspect = 1.6;

/// The surface with an albedo to look at: the height between 0 and 1 where colours say nothing.
Surface with_pattern(const Surface& surface) {
  constexpr float even = 0.01f;
  for (const auto& plane : surface.albedo.planes) {
    const auto [low, high] = std::minmax_element(plane.begin(), plane.end());
    if (*high - *low > even * *high) return surface;
  }
  if (!surface.has_height())
    throw Error("knit: the picture is of one brightness; give a sharp one");
  Surface seen = surface;
  const auto [low, high] = std::minmax_element(surface.height.begin(), surface.height.end());
  Grid<float> grey = surface.height;
  for (float& value : grey) value = (value - *low) / std::max(*high - *low, 1e-12f);
  seen.albedo = Image(std::move(grey));
  return seen;
}

/// The power of all planes, of the square roots of brightness.
Spectrum pattern_spectrum(const Surface& surface) {
  Spectrum all;
  for (const auto& plane : surface.albedo.planes) {
    Grid<float> root = plane;
    for (float& value : root) value = std::sqrt(std::max(0.0f, value));
    Spectrum one = power_spectrum(root, surface.mask, surface.extent, {.taper = 1.0});
    if (all.power.empty()) {
      all = std::move(one);
    } else {
      for (std::size_t k = 0; k < all.power.size(); ++k) all.power[k] += one.power[k];
    }
  }
  return all;
}

/// Frequencies of a wale and of a whole repeat up: x and y of the fabric, as columns.
///
/// Where the two shortest vectors of the lattice are far from a right angle, it is a centred one:
/// every second wave is missing that a rectangle would have.
Eigen::Matrix2d wale_and_repeat(const Lattice& lattice) {
  constexpr double right_enough = 0.25;  // cosine
  Eigen::Vector2d a = lattice.first, b = lattice.second;
  const double cosine = a.dot(b) / (a.norm() * b.norm());
  if (std::abs(cosine) > right_enough) {
    const Eigen::Vector2d across =
        cosine > 0.0 ? Eigen::Vector2d(2.0 * b - a) : Eigen::Vector2d(2.0 * b + a);
    if (std::abs(a.dot(across)) < 0.5 * std::abs(cosine) * a.norm() * across.norm()) {
      a *= 0.5;
      b = 0.5 * across;
    }
  }
  if (std::abs(a.x() * b.y()) < std::abs(b.x() * a.y())) std::swap(a, b);
  Eigen::Matrix2d both;
  both << (a.x() < 0.0 ? Eigen::Vector2d(-a) : a), (b.y() < 0.0 ? Eigen::Vector2d(-b) : b);
  return both;
}

Knit<> knit_on(const Eigen::Matrix2d& frequencies) {
  const Eigen::Matrix2d periods = frequencies.transpose().inverse();
  const Eigen::Vector2d wale = periods.col(0), repeat = periods.col(1);
  Knit<> knit;
  knit.wale_mm = wale.norm();
  knit.course_mm = repeat.norm();
  knit.rotation_rad = std::atan2(wale.y(), wale.x());
  knit.skew_rad = std::atan2(-repeat.x(), repeat.y()) - knit.rotation_rad;
  return knit;
}

/// The best of the numbers of courses that one repeat may have.
struct Choice {
  StitchFit stitch;
  int courses = 1;
  double runner_up = HUGE_VAL;  // how much another number leaves, over what this one leaves
  int tried = 0;
};

Choice choose_courses(const MeanStitch& mean, const Knit<>& lattice, int wanted) {
  constexpr int most = 12;
  constexpr double price = 0.1;  // of each further course, in what it must explain
  Choice best;
  double least = HUGE_VAL, second = HUGE_VAL;
  for (int courses = 1; courses <= most; ++courses) {
    const double aspect = lattice.course_mm / courses / lattice.wale_mm;
    const bool fits = aspect >= lowest_aspect && aspect <= highest_aspect;
    if (wanted > 0 ? courses != wanted : !fits) continue;
    const StitchFit stitch = fit_stitch(mean, lattice, courses);
    const double left = stitch.unexplained * (1.0 + price * (courses - 1));
    ++best.tried;
    if (left < least) {
      second = least;
      least = left;
      best.stitch = stitch;
      best.courses = courses;
    } else {
      second = std::min(second, left);
    }
  }
  best.runner_up = second / least;
  return best;
}

std::vector<std::string> remarks_on(const LatticeFit& lattice, const Choice& choice) {
  std::vector<std::string> remarks;
  if (lattice.wanders) {
    remarks.push_back(
        "The stitches are too uneven for waves over the whole picture: spacings are means from the "
        "peaks of the spectrum, and gradients are taken as zero.");
  }
  constexpr double clear = 1.3;
  if (choice.runner_up < clear) {
    remarks.push_back(
        "Another number of courses in the colour repeat explains nearly as much; give "
        "it with --components if you can count it.");
  }
  constexpr double poor = 0.2;
  if (choice.stitch.unexplained > poor) {
    remarks.push_back(
        "The loop of plain knit explains the mean stitch badly: do not rely on the "
        "yarn radius, the loop and the colours.");
  }
  remarks.push_back(knit_at_rest_remark);
  return remarks;
}

}  // namespace

Fit<Knit<>> fit_knit(const Surface& surface, const KnitFitOptions& options) {
  const Surface seen = with_pattern(surface);
  const Spectrum spectrum = pattern_spectrum(seen);
  const Eigen::Vector2d bin(1.0 / spectrum.extent.width(), 1.0 / spectrum.extent.height());
  const Knit<> guess = knit_on(wale_and_repeat(lattice_of(spectral_peaks(spectrum), bin)));

  constexpr double small_px = 12.0;  // of a stitch, enough for four waves in it
  constexpr double usual_aspect = 0.8;
  const double stitch =
      std::min(guess.wale_mm, std::min(guess.course_mm, usual_aspect * guess.wale_mm));
  const LatticeFit lattice = fit_lattice(knit_picture(seen, stitch, small_px), guess);

  constexpr int places = 32;  // of the mean stitch to a wale
  const double px = lattice.knit.wale_mm / seen.extent.pitch;
  const int cols = std::clamp(int(std::lround(px)), 12, places);
  const Choice choice =
      choose_courses(mean_stitch(seen, lattice.knit, cols), lattice.knit, options.courses);
  if (choice.tried == 0) {
    throw Error(
        "knit: a period of the picture is no whole number of courses; turn the picture so "
        "that courses run from left to right");
  }

  Fit<Knit<>> fit;
  fit.material = choice.stitch.knit;
  fit.sigma = fit.material;
  visit_fields(fit.sigma, [](const std::string&, const auto&, double& value) { value = 0.0; });
  LatticeFields sigma = lattice.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  // Pixels that fall in step with the stitches misplace the pattern by a part of one.
  constexpr double part_of_pixel = 0.02;
  const double off =
      part_of_pixel * seen.extent.pitch / std::min(seen.extent.width(), seen.extent.height());
  const LatticeFields least = (LatticeFields() << lattice.knit.wale_mm, lattice.knit.course_mm, 1.0,
                               1.0, 1.0 / seen.extent.width(), 1.0 / seen.extent.height())
                                  .finished();
  sigma = sigma.cwiseMax(off * least);
  sigma[1] /= choice.courses;
  fit.sigma = with_lattice_fields(fit.sigma, sigma);
  fit.sigma.yarn_radius_mm = choice.stitch.sigma[0];
  fit.sigma.loop_depth_mm = choice.stitch.sigma[1];
  fit.sigma.loop_width = choice.stitch.sigma[2];
  fit.sigma.loop_reach = choice.stitch.sigma[3];
  fit.sigma.wale_phase = choice.stitch.sigma[4];
  fit.sigma.course_phase = choice.stitch.sigma[5];
  for (auto& yarn : fit.sigma.yarns) {
    yarn.red = yarn.green = yarn.blue = choice.stitch.colour_sigma;
  }
  fit.cost = choice.stitch.unexplained;
  fit.runner_up_gap = choice.runner_up - 1.0;
  fit.starts = choice.tried;
  fit.agreeing = 1;
  fit.remarks = remarks_on(lattice, choice);
  return fit;
}

}  // namespace hada
