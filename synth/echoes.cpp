#include "synth/echoes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "synth/white_noise.h"

namespace hada {
namespace {

constexpr double spacing = 1.5;      // of rows of nodes, in standard deviations of the kernel
constexpr double reach = 6.07;       // standard deviations: the kernel has fallen to 1e-8
constexpr double most_nodes = 16.0;  // to a pixel

double cross(const Step<>& a, const Step<>& b) {
  return a.x * b.y - a.y * b.x;
}

// d^T M e, where the kernel is exp(-d^T M d / 2).
double form(const WrinkleComponent<>& kernel, const Step<>& d, const Step<>& e) {
  const double c = std::cos(kernel.angle_rad), s = std::sin(kernel.angle_rad);
  return (c * d.x + s * d.y) * (c * e.x + s * e.y) / (kernel.long_mm * kernel.long_mm) +
         (c * d.y - s * d.x) * (c * e.y - s * e.x) / (kernel.short_mm * kernel.short_mm);
}

// Each row of `noise` becomes the sum of the rows that lie whole numbers of `per_step` away.
Grid<float> echoed_rows(const Grid<float>& noise, const std::vector<double>& loudness,
                        int per_step) {
  const int margin = (int(loudness.size()) - 1) * per_step;
  Grid<float> sum(noise.rows() - 2 * margin, noise.cols());
  for_each_index(sum.rows(), [&](int row) {
    std::vector<double> total(std::size_t(sum.cols()), 0.0);
    for (int n = 1 - int(loudness.size()); n < int(loudness.size()); ++n) {
      const double loud = loudness[std::size_t(std::abs(n))];
      const auto from = noise.row(row + margin - n * per_step);
      for (std::size_t i = 0; i < total.size(); ++i) total[i] += loud * from[i];
    }
    std::copy(total.begin(), total.end(), sum.row(row).begin());
  });
  return sum;
}

Grid<float> echoed_columns(const Grid<float>& noise, const std::vector<double>& loudness,
                           int per_step) {
  const int margin = (int(loudness.size()) - 1) * per_step;
  Grid<float> sum(noise.rows(), noise.cols() - 2 * margin);
  for_each_index(sum.rows(), [&](int row) {
    const float* const from = noise.row(row).data() + margin;
    for (int col = 0; col < sum.cols(); ++col) {
      double total = loudness[0] * from[col];
      for (int n = 1; n < int(loudness.size()); ++n) {
        total += loudness[std::size_t(n)] *
                 (double(from[col - n * per_step]) + double(from[col + n * per_step]));
      }
      sum(row, col) = float(total);
    }
  });
  return sum;
}

}  // namespace

Echoes echoes_of(const Step<>& step, double repeats) {
  constexpr double faintest = 1e-5;
  const double width = 0.5 / (std::numbers::pi * repeats);
  // exp(-n^2 / repeats^2) for many repeats; the root is less smooth where its lines flow together.
  const int last = int(std::ceil(4.0 * repeats)) + 6;
  const int phases = 16 * last;  // of a periodic function: the mean of them is the integral
  std::vector<double> roots;
  for (int k = 0; k < phases; ++k) roots.push_back(std::sqrt(comb(double(k) / phases, width)));
  Echoes echoes{step, {}};
  for (int n = 0; n <= last; ++n) {
    double sum = 0.0;
    for (int k = 0; k < phases; ++k)
      sum += roots[std::size_t(k)] * std::cos(2.0 * std::numbers::pi * n * k / phases);
    if (n > 0 && std::abs(sum / phases) < faintest * echoes.loudness.front()) break;
    echoes.loudness.push_back(sum / phases);
  }
  return echoes;
}

Echoes none_across(const Step<>& step, const WrinkleComponent<>& kernel) {
  const Step<> turned{-step.y, step.x};
  const double share = form(kernel, step, turned) / form(kernel, step, step);
  const Step<> across{turned.x - share * step.x, turned.y - share * step.y};
  const double scale = spacing / std::sqrt(form(kernel, across, across));
  return {{scale * across.x, scale * across.y}, {1.0}};
}

void EchoLattice::divide(int one, int other) {
  per_one_ = one;
  per_other_ = other;
  a_ = {one_.step.x / one, one_.step.y / one};
  b_ = {other_.step.x / other, other_.step.y / other};
  aa_ = form(kernel_, a_, a_);
  ab_ = form(kernel_, a_, b_);
  bb_ = form(kernel_, b_, b_);
  falling_ = std::exp(-bb_);
}

double EchoLattice::reach_a() const {
  return reach / std::sqrt(aa_ - ab_ * ab_ / bb_);
}

double EchoLattice::reach_b() const {
  return reach / std::sqrt(bb_ - ab_ * ab_ / aa_);
}

// Of the waves that the nodes cannot tell from none, the longest: its frequency times the
// kernel's standard deviation along it.
double EchoLattice::least_frequency() const {
  const double determinant = aa_ * bb_ - ab_ * ab_;
  double least = HUGE_VAL;
  constexpr int farthest = 12;  // of rows that are much closer along one step than the other
  for (int a = 0; a <= farthest; ++a) {
    for (int b = -farthest; b <= farthest; ++b) {
      if (a == 0 && b <= 0) continue;
      least = std::min(least, (bb_ * a * a - 2.0 * ab_ * a * b + aa_ * b * b) / determinant);
    }
  }
  return std::sqrt(least);
}

std::optional<EchoLattice> EchoLattice::find(const WrinkleComponent<>& kernel, Echoes one,
                                             Echoes other, double pitch) {
  EchoLattice lattice(kernel, std::move(one), std::move(other));
  const double least_cell = pitch * pitch / most_nodes;
  const double whole = std::abs(cross(lattice.one_.step, lattice.other_.step));
  // Whole steps first, then as many nodes to each as their rows ask for.
  lattice.divide(1, 1);
  const double determinant = lattice.aa_ * lattice.bb_ - lattice.ab_ * lattice.ab_;
  double rows = std::sqrt(std::max(determinant, 0.0) / lattice.bb_) / spacing;
  double columns = std::sqrt(std::max(determinant, 0.0) / lattice.aa_) / spacing;
  while (whole > least_cell * rows * columns) {
    lattice.divide(std::max(1, int(std::ceil(rows))), std::max(1, int(std::ceil(columns))));
    if (std::abs(cross(lattice.a_, lattice.b_)) < least_cell) break;
    if (lattice.least_frequency() > (1.0 - 1e-9) / spacing) return lattice;
    rows *= 1.1;
    columns *= 1.1;
  }
  return std::nullopt;
}

std::array<double, 2> EchoLattice::node_at(double x, double y) const {
  const double area = cross(a_, b_);
  return {cross({x, y}, b_) / area, cross(a_, {x, y}) / area};
}

EchoLattice::Nodes EchoLattice::nodes_near(const Extent& window,
                                           const std::array<double, 2>& middle,
                                           std::uint64_t key) const {
  double low_a = HUGE_VAL, high_a = -HUGE_VAL, low_b = HUGE_VAL, high_b = -HUGE_VAL;
  for (const double side : {-0.5, 0.5}) {
    for (const double end : {-0.5, 0.5}) {
      const auto at = node_at(middle[0] + side * window.width(), middle[1] + end * window.height());
      low_a = std::min(low_a, at[0] - reach_a());
      high_a = std::max(high_a, at[0] + reach_a());
      low_b = std::min(low_b, at[1] - reach_b());
      high_b = std::max(high_b, at[1] + reach_b());
    }
  }
  Nodes nodes{std::int64_t(std::floor(low_a)), std::int64_t(std::floor(low_b)), {}};
  const auto margin_a = std::int64_t(one_.loudness.size() - 1) * per_one_;
  const auto margin_b = std::int64_t(other_.loudness.size() - 1) * per_other_;
  const double rows = std::ceil(high_a) - double(nodes.first_a) + 1.0 + 2.0 * double(margin_a);
  const double cols = std::ceil(high_b) - double(nodes.first_b) + 1.0 + 2.0 * double(margin_b);
  if (rows * cols > 3e8) {
    throw Error(
        "synthesis: a window of so many pixels, and noise that comes back so often, take too much "
        "memory; ask for a smaller window, or for a surface that tiles");
  }
  Grid<float> noise{int(rows), int(cols)};
  for_each_index(noise.rows(), [&](int row) {
    const std::uint64_t of_row = mixed(key, nodes.first_a - margin_a + row);
    for (int col = 0; col < noise.cols(); ++col)
      noise(row, col) = float(normal_of(mixed(of_row, nodes.first_b - margin_b + col)));
  });
  noise = echoed_columns(noise, other_.loudness, per_other_);
  nodes.values = echoed_rows(noise, one_.loudness, per_one_);
  return nodes;
}

// Row by row of nodes: a Gaussian across them, and in each row one around a place of its own.
double EchoLattice::felt_at(const Nodes& nodes, const std::array<double, 2>& at) const {
  const double across = aa_ - ab_ * ab_ / bb_;
  const double slant = ab_ / bb_;
  const double half = 0.5 * bb_;
  double sum = 0.0;
  const auto last = std::int64_t(std::floor(at[0] + reach_a()));
  for (auto a = std::int64_t(std::ceil(at[0] - reach_a())); a <= last; ++a) {
    const double off = at[0] - double(a);
    const double outside = across * off * off;
    const double middle = at[1] + slant * off;
    const double width = std::sqrt(std::max(0.0, reach * reach - outside) / bb_);
    const auto first = std::int64_t(std::ceil(middle - width));
    const auto count = std::int64_t(std::floor(middle + width)) - first + 1;
    // exp(-half (d - 1)^2) = exp(-half d^2) exp(half (2 d - 1)), and so on from node to node.
    const double d = middle - double(first);
    double weight = std::exp(-0.5 * outside - half * d * d);
    double ratio = std::exp(half * (2.0 * d - 1.0));
    const float* const line = &nodes.values(int(a - nodes.first_a), int(first - nodes.first_b));
    for (std::int64_t i = 0; i < count; ++i) {
      sum += weight * double(line[i]);
      weight *= ratio;
      ratio *= falling_;
    }
  }
  return sum;
}

void EchoLattice::add_to(Grid<float>& field, const Extent& window,
                         const std::array<double, 2>& middle, std::uint64_t key) const {
  const Nodes nodes = nodes_near(window, middle, key);
  // The squares of the kernel at all nodes add up to its area over that of a cell.
  const double area = std::numbers::pi * kernel_.long_mm * kernel_.short_mm;
  const double scale = kernel_.amplitude_mm * std::sqrt(std::abs(cross(a_, b_)) / area);
  for_each_index(field.rows(), [&](int row) {
    for (int col = 0; col < field.cols(); ++col) {
      const auto place = window.place(row, col);
      const auto at = node_at(middle[0] + place.x(), middle[1] + place.y());
      field(row, col) += float(scale * felt_at(nodes, at));
    }
  });
}

}  // namespace hada
