#include "fit/knit_harmonics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <ceres/jet.h>

namespace hada {
namespace {

constexpr int fields = lattice_field_count;
constexpr int most_harmonics = 22;
using Jet = ceres::Jet<double, fields>;

Knit<Jet> as_jets(const Knit<>& knit) {
  Knit<Jet> jets;
  const LatticeFields at = lattice_fields(knit);
  jets.wale_mm = Jet(at[0], 0);
  jets.course_mm = Jet(at[1], 1);
  jets.rotation_rad = Jet(at[2], 2);
  jets.skew_rad = Jet(at[3], 3);
  jets.wale_gradient_per_mm = Jet(at[4], 4);
  jets.course_gradient_per_mm = Jet(at[5], 5);
  return jets;
}

/// Powers 0 to `most` of exp(2 pi i cycles), a column each.
Eigen::ArrayXXcd waves(const Eigen::ArrayXd& cycles, int most) {
  Eigen::ArrayXXcd powers(cycles.size(), most + 1);
  powers.col(0).setOnes();
  for (Eigen::Index c = 0; c < cycles.size() && most > 0; ++c) {
    powers(c, 1) = std::polar(1.0, 2.0 * std::numbers::pi * cycles[c]);
  }
  for (int k = 2; k <= most; ++k) powers.col(k) = powers.col(k - 1) * powers.col(1);
  return powers;
}

}  // namespace

LatticeFields lattice_fields(const Knit<>& knit) {
  LatticeFields at;
  at << knit.wale_mm, knit.course_mm, knit.rotation_rad, knit.skew_rad, knit.wale_gradient_per_mm,
      knit.course_gradient_per_mm;
  return at;
}

Knit<> with_lattice_fields(Knit<> knit, const LatticeFields& at) {
  knit.wale_mm = at[0];
  knit.course_mm = at[1];
  knit.rotation_rad = at[2];
  knit.skew_rad = at[3];
  knit.wale_gradient_per_mm = at[4];
  knit.course_gradient_per_mm = at[5];
  return knit;
}

Window middle_of(const Extent& extent, double share) {
  const int rows = std::max(8, int(extent.rows * share));
  const int cols = std::max(8, int(extent.cols * share));
  return {(extent.rows - rows) / 2, (extent.cols - cols) / 2, rows, cols};
}

RowPhases phases_of(const Knit<>& knit, const Extent& extent, const Window& window, int row) {
  const Knit<Jet> jets = as_jets(knit);
  RowPhases phases{Eigen::ArrayX2d(window.cols, 2), {}, {}};
  phases.wale_turn.resize(window.cols, fields);
  phases.course_turn.resize(window.cols, fields);
  for (int c = 0; c < window.cols; ++c) {
    const Eigen::Vector2d place = extent.place(row, window.col + c);
    const auto [wale, course] = stitch_at(jets, place.x(), place.y());
    phases.cycles(c, 0) = wale.a;
    phases.cycles(c, 1) = course.a;
    phases.wale_turn.row(c) = wale.v.transpose();
    phases.course_turn.row(c) = course.v.transpose();
  }
  return phases;
}

Eigen::ArrayXXcd pattern(const std::vector<Harmonic>& harmonics, const RowPhases& phases) {
  int most_h = 0, most_k = 0;
  for (const auto& [h, k] : harmonics) {
    most_h = std::max(most_h, h);
    most_k = std::max(most_k, std::abs(k));
  }
  const Eigen::ArrayXXcd across = waves(phases.cycles.col(0), most_h);
  const Eigen::ArrayXXcd up = waves(phases.cycles.col(1), most_k);
  Eigen::ArrayXXcd all(phases.cycles.rows(), Eigen::Index(harmonics.size()));
  for (std::size_t m = 0; m < harmonics.size(); ++m) {
    const auto [h, k] = harmonics[m];
    all.col(Eigen::Index(m)) =
        across.col(h) * (k < 0 ? Eigen::ArrayXcd(up.col(-k).conjugate()) : up.col(k));
  }
  return all;
}

std::vector<Harmonic> strongest(const KnitPicture& picture, const Window& window,
                                const Knit<>& knit, int courses) {
  constexpr double finest = 0.35;  // cycles per pixel: what the small picture holds, less some room
  constexpr int most_h = 4;
  const int most_k = std::min(12, 3 * courses + 1);
  std::vector<Harmonic> all;
  for (int h = 0; h <= most_h; ++h) {
    for (int k = h == 0 ? 1 : -most_k; k <= most_k; ++k) {
      const double frequency = std::hypot(h / knit.wale_mm, k / knit.course_mm);
      if (frequency * picture.extent.pitch < finest) all.push_back({h, k});
    }
  }
  std::vector<double> power(all.size(), 0.0);
  const auto hann = [](int at, int count) {
    return std::pow(std::sin(std::numbers::pi * (at + 0.5) / count), 2);
  };
  for (const auto& plane : picture.planes) {
    double mean = 0.0;
    for (const float value : plane) mean += value / double(plane.size());
    const Eigen::VectorXcd zero = Eigen::VectorXcd::Zero(Eigen::Index(all.size()));
    const Eigen::VectorXcd sums = summed(window, zero, [&](Eigen::VectorXcd& sum, int row) {
      const auto here = pattern(all, phases_of(knit, picture.extent, window, row));
      Eigen::VectorXcd values(window.cols);
      for (int c = 0; c < window.cols; ++c) {
        values[c] = hann(row - window.row, window.rows) * hann(c, window.cols) *
                    (plane(row, window.col + c) - mean) * picture.mask(row, window.col + c);
      }
      sum = here.matrix().transpose() * values;
    });
    for (std::size_t m = 0; m < all.size(); ++m) power[m] += std::norm(sums[Eigen::Index(m)]);
  }
  std::vector<std::size_t> order(all.size());
  for (std::size_t m = 0; m < order.size(); ++m) order[m] = m;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return power[a] > power[b]; });
  std::vector<Harmonic> kept;
  constexpr double least_share = 1e-4;
  for (const auto m : order) {
    if (int(kept.size()) == most_harmonics || power[m] < least_share * power[order[0]]) break;
    kept.push_back(all[m]);
  }
  return kept;
}

}  // namespace hada
