#include "fit/normal_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int bins = 4096;
constexpr int degrees = 8;         // 0 to 7
constexpr double flattest = 1e-9;  // slope of a curve where it stays

constexpr const char* all_one_grey = "forged steel: the picture is all one grey; it shows no grain";

struct Histogram {
  double low;
  double width;  // of a bin
  std::vector<double> count;

  double place(double value) const { return (value - low) / width; }
};

Histogram histogram_of(const Grid<float>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (!(*high > *low)) throw Error(all_one_grey);
  Histogram h{*low, (double(*high) - *low) / bins, std::vector<double>(bins, 0.0)};
  for (const float value : values)
    h.count[std::size_t(std::clamp(int(h.place(value)), 0, bins - 1))] += 1.0;
  return h;
}

/// Chebyshev polynomials at t in [-1, 1].
std::array<double, degrees> basis(double t) {
  std::array<double, degrees> b{1.0, t};
  for (std::size_t k = 2; k < degrees; ++k) b[k] = 2.0 * t * b[k - 1] - b[k - 2];
  return b;
}

double bin_centre(int bin) {
  return 2.0 * (bin + 0.5) / bins - 1.0;
}

}  // namespace

double normal_quantile(double p) {
  // Acklam's rational start is not needed: Newton on erfc converges from the logistic one.
  double z = std::log(p / (1.0 - p)) / 1.702;
  for (int k = 0; k < 30; ++k) {
    const double below = 0.5 * std::erfc(-z / std::sqrt(2.0));
    const double density = std::exp(-0.5 * z * z) * 0.3989422804014327;
    const double step = std::clamp((below - p) / std::max(density, 1e-300), -0.5, 0.5);
    z -= step;
    if (std::abs(step) < 1e-12) break;
  }
  return z;
}

Scores normal_scores(const Grid<float>& values) {
  const Histogram h = histogram_of(values);
  const auto total = double(values.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(degrees, degrees);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(degrees);
  double below = 0.0;
  int used = 0;
  for (int bin = 0; bin < bins; ++bin) {
    const double count = h.count[std::size_t(bin)];
    if (count == 0.0) continue;
    ++used;
    const double score = normal_quantile((below + 0.5 * count) / total);
    below += count;
    const auto b = basis(bin_centre(bin));
    const Eigen::Map<const Eigen::VectorXd> row(b.data(), degrees);
    normal += count * row * row.transpose();
    right += count * score * row;
  }
  // As many degrees as levels bear; with few of them the curve is nearly a line.
  const int fitted = std::clamp(used / 3, 2, degrees);
  const Eigen::VectorXd curve =
      normal.topLeftCorner(fitted, fitted).ldlt().solve(right.head(fitted));
  std::vector<double> score(bins);
  for (int bin = 0; bin < bins; ++bin) {
    const auto b = basis(bin_centre(bin));
    score[std::size_t(bin)] = curve.dot(Eigen::Map<const Eigen::VectorXd>(b.data(), fitted));
  }
  // A tone keeps the order: where the curve would turn, it stays.
  for (int bin = 1; bin < bins; ++bin)
    score[std::size_t(bin)] = std::max(score[std::size_t(bin)], score[std::size_t(bin - 1)]);
  double sum = 0.0, squares = 0.0;
  for (int bin = 0; bin < bins; ++bin) {
    sum += h.count[std::size_t(bin)] * score[std::size_t(bin)];
    squares += h.count[std::size_t(bin)] * score[std::size_t(bin)] * score[std::size_t(bin)];
  }
  const double mean = sum / total;
  const double deviation = std::sqrt(std::max(squares / total - mean * mean, 1e-300));
  Scores scores{Grid<float>(values.rows(), values.cols()), 0.0};
  for (int bin = 0; bin < bins; ++bin) {
    const int next = std::min(bin + 1, bins - 1), last = std::max(bin - 1, 0);
    const double rise = (score[std::size_t(next)] - score[std::size_t(last)]) / (next - last);
    scores.log_slope += h.count[std::size_t(bin)] / total *
                        std::log(std::max(rise / (deviation * h.width), flattest));
  }
  for_each_index(values.rows(), [&](int row) {
    for (int col = 0; col < values.cols(); ++col) {
      const double place = std::clamp(h.place(values(row, col)) - 0.5, 0.0, bins - 1.0);
      const int bin = std::min(int(place), bins - 2);
      const double part = place - bin;
      const double at = (1.0 - part) * score[std::size_t(bin)] + part * score[std::size_t(bin + 1)];
      scores.values(row, col) = float((at - mean) / deviation);
    }
  });
  return scores;
}

Scores standard_scores(const Grid<float>& values) {
  const auto total = double(values.size());
  double sum = 0.0, squares = 0.0;
  for (const float value : values) sum += value;
  const double mean = sum / total;
  for (const float value : values) squares += (value - mean) * (value - mean);
  const double deviation = std::sqrt(squares / total);
  if (!(deviation > 0.0)) throw Error(all_one_grey);
  Scores scores{values, -std::log(deviation)};
  for (float& value : scores.values) value = float((value - mean) / deviation);
  return scores;
}

}  // namespace hada
