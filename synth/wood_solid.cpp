#include "synth/wood_solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "synth/fractal.h"

namespace hada {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double steps_per_year = 16.0;

double eased(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// 1 well inside a disc, 0 well outside, softened over `soft`.
double inside_disc(double distance, double radius, double soft) {
  return std::clamp(0.5 + (radius - distance) / soft, 0.0, 1.0);
}

double median_width(const std::vector<double>& radii) {
  std::vector<double> widths;
  for (std::size_t k = 1; k < radii.size(); ++k) widths.push_back(radii[k] - radii[k - 1]);
  if (widths.empty()) return radii.empty() ? 1.0 : radii.front();
  std::nth_element(widths.begin(), widths.begin() + std::ptrdiff_t(widths.size() / 2),
                   widths.end());
  return std::max(widths[widths.size() / 2], 1e-6);
}

}  // namespace

WoodSolid::WoodSolid(const Wood<>& wood, Seed seed, Ripples ripples)
    : wood_(wood),
      wobble_(hash(seed, 1)),
      fluctuation_(hash(seed, 2)),
      fibres_(hash(seed, 3)),
      scattered_(hash(seed, 4)),
      boundary_(hash(seed, 5)),
      ripples_(std::move(ripples)) {
  const auto& radii = wood_.ring_radii_mm;
  usual_width_ = median_width(radii);
  for (const auto& lobe : wood_.lobes)
    whole_orders_ = whole_orders_ && lobe.order == std::floor(lobe.order);
  wave_start_ = std::cos(wood_.wave_phase_rad);
  if (!radii.empty() && radii.front() > 1.6 * usual_width_)
    inner_years_ = std::max(0.0, std::round(radii.front() / usual_width_) - 1.0);
  const double widest = wood_.vessel_radius_mm + 3.0 * wood_.vessel_radius_sd_mm;
  const double spacing = 1.0 / std::sqrt(std::max(wood_.vessel_density_per_mm2, 1e-6));
  vessel_cell_ = std::max(spacing, 2.0 * widest);
  if (wood_.fluctuation > 0.0) {
    const double years = inner_years_ + double(radii.size()) + 2.0;
    for (double k = 0.0; k <= years * steps_per_year; k += 1.0)
      turn_at_zero_.push_back(fractal_noise(fluctuation_, 0.0, k / steps_per_year / 4.0));
  }
}

/// `effective_radius`; cosines of whole multiples of theta come from those of theta itself.
double WoodSolid::growth_at(double r, double dx, double dy, double theta) const {
  if (!whole_orders_) return effective_radius(wood_.lobes, r, theta);
  if (!(r > 0.0)) return 0.0;
  const double c = dx / r, s = dy / r;
  double cosine = 1.0, sine = 0.0, order = 0.0, factor = 1.0;
  for (const auto& lobe : wood_.lobes) {
    if (lobe.order < order) {
      cosine = 1.0;
      sine = order = 0.0;
    }
    for (; order < lobe.order; order += 1.0) {
      const double next = cosine * c - sine * s;
      sine = sine * c + cosine * s;
      cosine = next;
    }
    factor += share_at(lobe, r) * (lobe.cosine * cosine + lobe.sine * sine);
  }
  return r * factor;
}

/// Rings from the pith; those before the first that is listed are of one width, and nothing is
/// known beyond the last.
double WoodSolid::year_at(double rho) const {
  const auto& radii = wood_.ring_radii_mm;
  if (radii.empty()) return 0.5 * std::min(rho / usual_width_, 1.0);
  if (rho < radii.front()) return std::max(rho, 0.0) / radii.front() * (inner_years_ + 1.0);
  const auto after = std::upper_bound(radii.begin(), radii.end(), rho);
  const double k = double(after - radii.begin());
  if (after == radii.end()) {
    const double most = 1.0 - wood_.latewood_share;  // earlywood until the next ring is known
    return inner_years_ + k + std::min((rho - radii.back()) / usual_width_, 0.999 * most);
  }
  return inner_years_ + k + (rho - *(after - 1)) / (*after - *(after - 1));
}

/// The effective radius of the boundary of ring `year`, a whole number.
double WoodSolid::radius_of(double year) const {
  const auto& radii = wood_.ring_radii_mm;
  if (radii.empty()) return year * usual_width_;
  const double listed = year - inner_years_ - 1.0;
  if (listed < 0.0) return radii.front() * year / (inner_years_ + 1.0);
  const std::size_t k = std::size_t(listed);
  return k < radii.size() ? radii[k] : radii.back() + double(k + 1 - radii.size()) * usual_width_;
}

/// The arc of the fluctuation, 0 where z is 0. It is the fractal itself, so that its slope, below 4
/// for each lattice step, is the fluctuation of the gradient.
double WoodSolid::fluctuation_at(double year, double z) const {
  const double size = wood_.fluctuation_mm, at = year * steps_per_year;
  const std::size_t k = std::min(std::size_t(at), turn_at_zero_.size() - 2);
  const double at_zero =
      turn_at_zero_[k] + (at - double(k)) * (turn_at_zero_[k + 1] - turn_at_zero_[k]);
  return 0.25 * wood_.fluctuation * size *
         (fractal_noise(fluctuation_, z / size, year / 4.0) - at_zero);
}

double WoodSolid::arc_of(double year, double z) const {
  const double wave = turn / wood_.wave_length_mm;
  double arc = wood_.spiral * z;
  if (wood_.wave_amplitude > 0.0) {
    arc += wood_.wave_amplitude / wave * (wave_start_ - std::cos(wave * z + wood_.wave_phase_rad));
  }
  if (wood_.interlock_amplitude > 0.0) {
    arc += wood_.interlock_amplitude * z *
           std::sin(turn * year / wood_.interlock_period + wood_.interlock_phase_rad);
  }
  if (wood_.fluctuation > 0.0) arc += fluctuation_at(year, z);
  return arc;
}

/// The phase of Kawai's equation 3: integral of G / r from 0 to z.
double WoodSolid::turn_at(double r, double year, double z) const {
  return arc_of(year, z) / std::max(r, 1e-6);
}

WoodSolid::Place WoodSolid::place_at(const StemVector& at) const {
  const auto [x, y, z] = at;
  const double dx = x - wood_.pith_mm[0] - wood_.pith_lean[0] * z;
  const double dy = y - wood_.pith_mm[1] - wood_.pith_lean[1] * z;
  Place place;
  place.r = std::sqrt(dx * dx + dy * dy);
  place.theta = std::atan2(dy, dx);
  place.rho = growth_at(place.r, dx, dy, place.theta) + wood_.taper * z;
  place.rho += ripples_.height_at(at);
  if (wood_.wobble_mm > 0.0) {
    // Looked up along the circle, so that it closes; it dies out towards the pith.
    const double around = place.r / (place.r + usual_width_);
    place.rho += wood_.wobble_mm * around *
                 fractal_noise(wobble_, 3.0 * dx / place.r + 0.05 * place.rho,
                               3.0 * dy / place.r + 0.01 * z);
  }
  place.year = year_at(place.rho);
  place.angle = place.theta - turn_at(place.r, place.year, z);
  place.section_x = place.rho * std::cos(place.angle);
  place.section_y = place.rho * std::sin(place.angle);
  return place;
}

WoodSolid::Place WoodSolid::place_in_section(double rho, double angle) const {
  return {rho, angle, rho, year_at(rho), angle, rho * std::cos(angle), rho * std::sin(angle)};
}

double WoodSolid::gradient_at(const Place& place, double z) const {
  const double h = 1e-3 * std::min(wood_.wave_length_mm, wood_.fluctuation_mm);
  const double up = turn_at(place.r, place.year, z + h);
  return (up - turn_at(place.r, place.year, z - h)) / (2.0 * h) * place.r;
}

StemVector WoodSolid::fibre_at(const StemVector& at) const {
  const Place place = place_at(at);
  const double slope = gradient_at(place, at[2]);
  const double length = std::sqrt(1.0 + slope * slope);
  return {-slope * std::sin(place.theta) / length, slope * std::cos(place.theta) / length,
          1.0 / length};
}

/// How dark the vessels of a uniform scatter make the place, 0 to 1 (Kawai, section 5.3).
double WoodSolid::scattered_vessels(const Place& place, double soft_mm) const {
  const double in_cell = wood_.vessel_density_per_mm2 * vessel_cell_ * vessel_cell_;
  const auto i = std::int64_t(std::floor(place.section_x / vessel_cell_));
  const auto j = std::int64_t(std::floor(place.section_y / vessel_cell_));
  double dark = 0.0;
  for (std::int64_t a = i - 1; a <= i + 1; ++a) {
    for (std::int64_t b = j - 1; b <= j + 1; ++b) {
      // A Poisson number of vessels to a cell, by multiplying uniforms (Knuth).
      double product = uniform(scattered_, a, b, 0);
      const double least = std::exp(-in_cell);
      for (std::int64_t n = 1; product > least && n < 64; ++n) {
        const double x = (double(a) + uniform(scattered_, a, b, 4 * n)) * vessel_cell_;
        const double y = (double(b) + uniform(scattered_, a, b, 4 * n + 1)) * vessel_cell_;
        const double radius = wood_.vessel_radius_mm +
                              wood_.vessel_radius_sd_mm * gaussian(scattered_, a, b, 4 * n + 2);
        const double distance = std::hypot(place.section_x - x, place.section_y - y);
        if (distance < radius + soft_mm)
          dark = std::max(dark, inside_disc(distance, radius, soft_mm));
        product *= uniform(scattered_, a, b, 4 * n + 3);
      }
    }
  }
  return dark;
}

/// The same of the vessels along the boundary inside the place (Kawai, section 5.4).
double WoodSolid::boundary_vessels(const Place& place, double soft_mm) const {
  const double ring = std::floor(place.year);
  const double boundary_rho = radius_of(ring);
  const double radius = wood_.ring_vessel_radius_mm;
  if (ring < 1.0 || place.rho - boundary_rho > 5.0 * radius + soft_mm) return 0.0;
  const double count = std::max(1.0, std::floor(turn * wood_.ring_vessels_per_mm * boundary_rho));
  const double here = std::floor(place.angle / turn * count);
  const double largest = 1.25 * radius;
  const double reach = std::ceil(1.0 + (radius + soft_mm) * wood_.ring_vessels_per_mm);
  const Seed key = hash(boundary_, std::int64_t(ring));
  double dark = 0.0;
  for (double k = here - reach; k <= here + reach; k += 1.0) {
    const auto index = std::int64_t(k - count * std::floor(k / count));
    const double theta = (k + 0.5 + 0.8 * (uniform(key, index, 0) - 0.5)) * turn / count;
    const double away = std::remainder(place.angle - theta, turn);
    if (std::abs(boundary_rho * away) > largest + soft_mm) continue;  // most end here
    const double size = radius * (0.75 + 0.5 * uniform(key, index, 1));
    const double rho = boundary_rho + size * 1.15 + 2.0 * radius * uniform(key, index, 2);
    // Along and across the ring: the arc between two places of one ring is nearly straight.
    const double across = place.rho - rho, along = rho * away;
    if (std::abs(across) > size + soft_mm || std::abs(along) > size + soft_mm) continue;
    const double distance = std::sqrt(across * across + along * along);
    dark = std::max(dark, inside_disc(distance, size, soft_mm));
  }
  return dark;
}

/// What fibres and vessels multiply the colour by.
double WoodSolid::shade_at(const Place& place, double soft_mm) const {
  double shade = 1.0;
  if (wood_.fibre_shift > 0.0) {
    shade += wood_.fibre_shift * value_noise(fibres_, place.section_x / wood_.fibre_mm,
                                             place.section_y / wood_.fibre_mm);
  }
  double dark = 0.0;
  if (wood_.vessel_density_per_mm2 > 0.0) dark = scattered_vessels(place, soft_mm);
  if (wood_.ring_vessels_per_mm > 0.0) dark = std::max(dark, boundary_vessels(place, soft_mm));
  return shade * (1.0 - dark * (1.0 - wood_.vessel_shade));
}

std::array<float, 3> WoodSolid::colour_at(const Place& place, double soft_mm) const {
  const double phase = place.year - std::floor(place.year);
  const double start = 1.0 - wood_.latewood_share;
  const double onset = std::max(wood_.latewood_onset * wood_.latewood_share, 1e-3);
  double late = eased((phase - start) / onset);
  // A pixel that a boundary runs through sees both sides of it.
  const double to_inner = place.rho - radius_of(std::floor(place.year));
  if (place.year >= 1.0 && to_inner < 0.5 * soft_mm)
    late += (1.0 - late) * (0.5 - to_inner / soft_mm);
  const double to_outer = radius_of(std::floor(place.year) + 1.0) - place.rho;
  if (to_outer < 0.5 * soft_mm) late -= late * (0.5 - to_outer / soft_mm);
  const double shade = shade_at(place, soft_mm);
  std::array<float, 3> colour;
  for (std::size_t c = 0; c < 3; ++c) {
    const double early = wood_.early_rgb[c];
    colour[c] = float(std::clamp((early + late * (wood_.late_rgb[c] - early)) * shade, 0.0, 1.0));
  }
  return colour;
}

}  // namespace hada
