#include "fit/slow_waves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "fit/half_steps.h"
#include "fit/whittle.h"

namespace hada {
namespace {

using Complex = std::complex<double>;

constexpr int slow = 8;                     // steps of frequency from 0
constexpr int reach = 6;                    // steps further, from where power leaks to them
constexpr int halves = 2 * (slow + reach);  // the waves are half a step apart

/// 1, x, y, x^2, x y, y^2 at (x, y): as many as a levelling takes off.
int terms_of(const std::string& levelling) {
  if (levelling == "plane") return 3;
  return levelling == "quadratic" ? 6 : 1;
}

double term(int which, double x, double y) {
  switch (which) {
    case 0:
      return 1.0;
    case 1:
      return x;
    case 2:
      return y;
    case 3:
      return x * x;
    case 4:
      return x * y;
    default:
      return y * y;
  }
}

/// Places (x, y) of a half plane up to `most` along x and y; on the axis x = 0 from `least_y` on.
std::vector<Eigen::Vector2i> half_plane(int most, int least_y) {
  std::vector<Eigen::Vector2i> places;
  for (int x = 0; x <= most; ++x) {
    for (int y = -most; y <= most; ++y) {
      if (x == 0 && y < least_y) continue;
      places.emplace_back(x, y);
    }
  }
  return places;
}

/// (plain + excess)^-1, on what `plain` knows of at all, where an excess below 0 is none.
Eigen::MatrixXd inverse_of_scatter(const Eigen::MatrixXd& plain, const Eigen::MatrixXd& excess) {
  constexpr double nothing = 1e-14;  // of the most that is known of any direction
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> known(plain);
  std::vector<int> kept;
  for (int k = 0; k < known.eigenvalues().size(); ++k) {
    if (known.eigenvalues()[k] > nothing * known.eigenvalues().maxCoeff()) kept.push_back(k);
  }
  const Eigen::MatrixXd to_one = known.eigenvectors()(Eigen::all, kept) *
                                 known.eigenvalues()(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> more(to_one.transpose() * excess * to_one);
  const Eigen::MatrixXd axes = to_one * more.eigenvectors();
  const Eigen::VectorXd scatter = 1.0 + more.eigenvalues().cwiseMax(0.0).array();
  return axes * scatter.cwiseInverse().asDiagonal() * axes.transpose();
}

}  // namespace

SlowWaves::SlowWaves(const Spectrum& spectrum, const std::string& levelling)
    : extent_(spectrum.extent) {
  const Grid<double>& taper = spectrum.taper;
  const auto sum_of = [&](const std::function<double(double weight, double x, double y)>& value,
                          int most) {
    Grid<double> map(taper.rows(), taper.cols());
    for (int row = 0; row < map.rows(); ++row) {
      for (int col = 0; col < map.cols(); ++col) {
        const double x = 2.0 * (col + 0.5) / map.cols() - 1.0;
        const double y = 1.0 - 2.0 * (row + 0.5) / map.rows();
        if (taper(row, col) > 0.0) map(row, col) = value(taper(row, col), x, y);
      }
    }
    return HalfSteps(map, most);
  };
  for (const auto& place : half_plane(slow, 1)) {
    if (place.squaredNorm() < slow * slow) ordinates_.push_back(place);
  }
  const int count = int(ordinates_.size()), terms = terms_of(levelling);
  const HalfSteps weight = sum_of([](double w, double, double) { return w; }, halves + 2 * slow);
  const HalfSteps squared = sum_of([](double w, double, double) { return w * w; }, 4 * slow);
  std::vector<HalfSteps> bare, weighted;  // the terms of levelling
  for (int k = 0; k < terms; ++k) {
    bare.push_back(sum_of([k](double, double x, double y) { return term(k, x, y); }, halves));
    weighted.push_back(
        sum_of([k](double w, double x, double y) { return w * term(k, x, y); }, 2 * slow));
  }
  // Gram matrix of the terms: sums of products, each a term of a higher degree at frequency 0.
  Eigen::MatrixXd gram(terms, terms);
  for (int k = 0; k < terms; ++k) {
    for (int l = 0; l < terms; ++l) {
      gram(k, l) =
          sum_of([k, l](double, double x, double y) { return term(k, x, y) * term(l, x, y); }, 0)
              .at(0, 0)
              .real();
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(gram);

  const auto waves = half_plane(halves, 0);
  seen_.resize(2 * count, 2 * Eigen::Index(waves.size()));
  unlevelled_.resize(count, Eigen::Index(waves.size()));
  const double whole = weight.at(0, 0).real();
  for (int j = 0; j < count; ++j) {
    const int x = 2 * ordinates_[std::size_t(j)].x(), y = 2 * ordinates_[std::size_t(j)].y();
    // An ordinate is the sum of w exp(-2 pi i f x) over heights less their mean, weighed by w, and
    // less what levelling took.
    const Complex mean = std::conj(weight.at(x, y)) / whole;
    Eigen::VectorXcd inside(terms);
    for (int k = 0; k < terms; ++k) {
      const HalfSteps& term_seen = weighted[std::size_t(k)];
      inside[k] = std::conj(term_seen.at(x, y)) - mean * term_seen.at(0, 0);
    }
    const Eigen::VectorXd real = solver.solve(inside.real()),
                          imaginary = solver.solve(inside.imag());
    for (std::size_t f = 0; f < waves.size(); ++f) {
      const auto sensitivity = [&](int a, int b) {
        Complex sum = weight.at(a - x, b - y) - mean * weight.at(a, b);
        for (int k = 0; k < terms; ++k)
          sum -= Complex(real[k], imaginary[k]) * bare[std::size_t(k)].at(a, b);
        return sum;
      };
      const int a = waves[f].x(), b = waves[f].y();
      const Complex here = sensitivity(a, b), there = sensitivity(-a, -b);
      // A wave c cos + s sin of independent c and s: what an ordinate makes of either.
      const Complex cosine = 0.5 * (here + there), sine = Complex(0.0, -0.5) * (here - there);
      seen_(2 * j, Eigen::Index(f)) = cosine.real();
      seen_(2 * j, Eigen::Index(waves.size() + f)) = sine.real();
      seen_(2 * j + 1, Eigen::Index(f)) = cosine.imag();
      seen_(2 * j + 1, Eigen::Index(waves.size() + f)) = sine.imag();
      unlevelled_(j, Eigen::Index(f)) =
          0.5 * (std::norm(weight.at(a - x, b - y)) + std::norm(weight.at(-a - x, -b - y)));
    }
  }
  const auto half = Eigen::Index(waves.size());
  squared_ = seen_.leftCols(half).cwiseAbs2() + seen_.rightCols(half).cwiseAbs2();
  smooth_.resize(count, count);
  for (int j = 0; j < count; ++j) {
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector2i apart = 2 * (ordinates_[std::size_t(j)] - ordinates_[std::size_t(k)]);
      const Eigen::Vector2i sum = 2 * (ordinates_[std::size_t(j)] + ordinates_[std::size_t(k)]);
      smooth_(j, k) =
          (std::norm(squared.at(apart.x(), apart.y())) + std::norm(squared.at(sum.x(), sum.y()))) /
          std::norm(squared.at(0, 0));
    }
  }
}

/// S at the waves of the half plane; that at frequency 0 is its own other half.
Eigen::VectorXd SlowWaves::powers(const Wrinkle<>& wrinkle) const {
  const auto spectrum = spectrum_of(wrinkle);
  const auto waves = half_plane(halves, 0);
  Eigen::VectorXd power(Eigen::Index(waves.size()));
  for (std::size_t f = 0; f < waves.size(); ++f) {
    const double s =
        spectrum(0.5 * waves[f].x() / extent_.width(), 0.5 * waves[f].y() / extent_.height());
    power[Eigen::Index(f)] = waves[f].isZero() ? s : 2.0 * s;
  }
  return power;
}

int SlowWaves::ordinate_of(const Cell& cell) const {
  if (cell.count != 1) return -1;
  Eigen::Vector2i place(int(std::lround(cell.fx * extent_.width())),
                        int(std::lround(cell.fy * extent_.height())));
  if (place.x() < 0 || (place.x() == 0 && place.y() < 0)) place = -place;
  const auto at = std::find(ordinates_.begin(), ordinates_.end(), place);
  return at == ordinates_.end() ? -1 : int(at - ordinates_.begin());
}

/// The power of the ordinates under those powers of the waves.
Eigen::VectorXd SlowWaves::expected(const Eigen::VectorXd& power) const {
  return (squared_ * power).reshaped(2, Eigen::Index(ordinates_.size())).colwise().sum();
}

/// The derivatives of the logarithms of the ordinates by the packed fields, a row each.
Eigen::MatrixXd SlowWaves::slopes(const Wrinkle<>& wrinkle) const {
  constexpr double step = 1e-4;
  const auto packed = pack(wrinkle);
  Eigen::MatrixXd slopes(Eigen::Index(ordinates_.size()), Eigen::Index(packed.size()));
  for (std::size_t k = 0; k < packed.size(); ++k) {
    const auto logarithms = [&](double by) {
      auto moved = packed;
      moved[k] += by;
      return expected(powers(unpack(wrinkle, moved.data()))).array().log().matrix().eval();
    };
    slopes.col(Eigen::Index(k)) = (logarithms(step) - logarithms(-step)) / (2.0 * step);
  }
  return slopes;
}

std::vector<Cell> SlowWaves::levelled(std::vector<Cell> cells, const Wrinkle<>& wrinkle) const {
  const Eigen::VectorXd power = powers(wrinkle);
  const Eigen::VectorXd left = expected(power).cwiseQuotient(unlevelled_ * power);
  for (Cell& cell : cells) {
    const int j = ordinate_of(cell);
    if (j >= 0) cell.correction *= left[j];
  }
  return cells;
}

Eigen::MatrixXd SlowWaves::information(const std::vector<Cell>& cells, const Wrinkle<>& wrinkle,
                                       const Eigen::MatrixXd& jacobian, double independence) const {
  const Eigen::VectorXd power = powers(wrinkle);
  const Eigen::VectorXd alone = expected(power);
  const Eigen::VectorXd root = power.cwiseSqrt();
  Eigen::MatrixXd loud(seen_.rows(), seen_.cols());
  loud << seen_.leftCols(root.size()) * root.asDiagonal(),
      seen_.rightCols(root.size()) * root.asDiagonal();
  const Eigen::MatrixXd covariance = loud * loud.transpose();
  const Eigen::MatrixXd exact = slopes(wrinkle);
  const auto model = densities(wrinkle, cells);

  struct Slow {
    int cell, ordinate;
    double share;  // of the expected power that is no noise of the measurement
  };
  std::vector<Slow> here;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int j = ordinate_of(cells[i]);
    if (j >= 0) here.push_back({int(i), j, 1.0 - cells[i].noise / model[i]});
  }
  const Eigen::MatrixXd plain = jacobian.transpose() * jacobian;
  Eigen::MatrixXd excess = Eigen::MatrixXd::Zero(plain.rows(), plain.cols());
  Eigen::MatrixXd follows = plain;
  for (const Slow& one : here) {
    const auto a = jacobian.row(one.cell);
    follows += a.transpose() * (std::sqrt(independence) * one.share * exact.row(one.ordinate) - a);
    for (const Slow& other : here) {
      // The covariance of |a + i b|^2 is twice the sum of the squared covariances of the parts.
      const auto parts = covariance.block<2, 2>(2 * one.ordinate, 2 * other.ordinate);
      const double coherence = 2.0 * parts.squaredNorm() * one.share * other.share /
                               (alone[one.ordinate] * alone[other.ordinate]);
      const auto b = jacobian.row(other.cell);
      // A smooth score has the scatter that `independence` tells; only what differs from it counts.
      const double smooth = smooth_(one.ordinate, other.ordinate);
      excess += independence * (coherence * a.transpose() * b -
                                0.5 * smooth * (a.transpose() * a + b.transpose() * b));
    }
  }
  return follows.transpose() * inverse_of_scatter(plain, 0.5 * (excess + excess.transpose())) *
         follows;
}

}  // namespace hada
