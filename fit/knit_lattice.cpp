#include "fit/knit_lattice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "fit/knit_harmonics.h"

namespace hada {
namespace {

constexpr int fields = lattice_field_count;
constexpr int background = 6;  // 1, x, y, x^2, xy, y^2
// Where stitches wander by half of one, waves as wide as the picture have no best place any more.
constexpr double least_explained = 0.6;

/// A row of pixels as the solver sees it; pixels outside the mask are zero everywhere.
struct RowEquations {
  Eigen::MatrixXd basis;   // pixels x linear functions: background, then cosine and sine
  Eigen::MatrixXd values;  // pixels x planes
  RowPhases phases;
};

/// One linearisation of the problem.
struct Linear {
  Eigen::MatrixXd coefficients;                       // linear functions x planes
  Eigen::MatrixXd gram;                               // of the linear functions
  std::vector<Eigen::MatrixXd> cross;                 // linear functions x fields, for each plane
  Eigen::Matrix<double, fields, fields> information;  // with the linear part projected out
  LatticeFields gradient;
  double cost = 0.0, variance = 0.0;
};

struct LatticeProblem {
  const KnitPicture& picture;
  Window window;
  std::vector<Harmonic> harmonics;

  Eigen::Index size() const { return background + 2 * Eigen::Index(harmonics.size()); }

  RowEquations row_at(const Knit<>& knit, int row) const {
    RowEquations equations{Eigen::MatrixXd(window.cols, size()),
                           Eigen::MatrixXd(window.cols, Eigen::Index(picture.planes.size())),
                           phases_of(knit, picture.extent, window, row)};
    const Eigen::ArrayXXcd here = pattern(harmonics, equations.phases);
    for (Eigen::Index m = 0; m < here.cols(); ++m) {
      equations.basis.col(background + 2 * m) = here.col(m).real().matrix();
      equations.basis.col(background + 2 * m + 1) = here.col(m).imag().matrix();
    }
    const double v = 2.0 * (row + 0.5) / picture.extent.rows - 1.0;
    for (int c = 0; c < window.cols; ++c) {
      const double u = 2.0 * (window.col + c + 0.5) / picture.extent.cols - 1.0;
      equations.basis.row(c).head<background>() << 1.0, u, v, u * u, u * v, v * v;
      for (std::size_t p = 0; p < picture.planes.size(); ++p) {
        equations.values(c, Eigen::Index(p)) = picture.planes[p](row, window.col + c);
      }
      if (picture.mask(row, window.col + c)) continue;
      equations.basis.row(c).setZero();
      equations.values.row(c).setZero();
    }
    return equations;
  }

  /// How a plane with `coefficients` changes with the six numbers: pixels x fields.
  Eigen::MatrixXd slopes(const RowEquations& equations, const Eigen::VectorXd& coefficients) const {
    Eigen::VectorXd by_wale = Eigen::VectorXd::Zero(window.cols), by_course = by_wale;
    for (std::size_t m = 0; m < harmonics.size(); ++m) {
      const Eigen::Index at = background + 2 * Eigen::Index(m);
      const Eigen::VectorXd turn = 2.0 * std::numbers::pi *
                                   (coefficients[at + 1] * equations.basis.col(at) -
                                    coefficients[at] * equations.basis.col(at + 1));
      by_wale += harmonics[m].h * turn;
      by_course += harmonics[m].k * turn;
    }
    return by_wale.asDiagonal() * equations.phases.wale_turn +
           by_course.asDiagonal() * equations.phases.course_turn;
  }

  /// The best linear part, and the normal equations of the rest.
  Linear at(const Knit<>& knit) const {
    const Eigen::Index n = size(), planes = Eigen::Index(picture.planes.size());
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(n, n + 2 * planes);
    const Eigen::MatrixXd moments = summed(window, zero, [&](Eigen::MatrixXd& sum, int row) {
      const RowEquations equations = row_at(knit, row);
      sum.leftCols(n).selfadjointView<Eigen::Lower>().rankUpdate(equations.basis.transpose());
      sum.middleCols(n, planes) = equations.basis.transpose() * equations.values;
      sum.row(0).tail(planes) = equations.values.colwise().squaredNorm();
    });
    Linear linear;
    linear.gram = moments.leftCols(n).selfadjointView<Eigen::Lower>();
    const double count = linear.gram(0, 0);
    linear.gram.diagonal().array() += 1e-9 * count;
    const Eigen::LLT<Eigen::MatrixXd> solver(linear.gram);
    linear.coefficients = solver.solve(moments.middleCols(n, planes));
    for (Eigen::Index p = 0; p < planes; ++p) {
      const double squares = moments(0, n + planes + p), sum = moments(0, n + p);
      linear.cost += squares - linear.coefficients.col(p).dot(moments.col(n + p));
      linear.variance += squares - sum * sum / count;
    }
    add_derivatives(linear, knit, solver);
    return linear;
  }

  void add_derivatives(Linear& linear, const Knit<>& knit,
                       const Eigen::LLT<Eigen::MatrixXd>& solver) const {
    const Eigen::Index n = size(), planes = Eigen::Index(picture.planes.size());
    const Eigen::Index each = n + fields + 1;
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(each * planes, fields);
    const Eigen::MatrixXd sums = summed(window, zero, [&](Eigen::MatrixXd& sum, int row) {
      const RowEquations equations = row_at(knit, row);
      const Eigen::MatrixXd residuals = equations.values - equations.basis * linear.coefficients;
      for (Eigen::Index p = 0; p < planes; ++p) {
        const Eigen::MatrixXd by_field = slopes(equations, linear.coefficients.col(p));
        sum.middleRows(p * each, n) = equations.basis.transpose() * by_field;
        sum.middleRows(p * each + n, fields) = by_field.transpose() * by_field;
        sum.row(p * each + n + fields) = residuals.col(p).transpose() * by_field;
      }
    });
    linear.information.setZero();
    linear.gradient.setZero();
    for (Eigen::Index p = 0; p < planes; ++p) {
      const Eigen::MatrixXd cross = sums.middleRows(p * each, n);
      linear.information +=
          sums.middleRows(p * each + n, fields) - cross.transpose() * solver.solve(cross);
      linear.gradient += sums.row(p * each + n + fields).transpose();
      linear.cross.push_back(cross);
    }
  }

  Knit<> solved(Knit<> knit) const {
    constexpr int most_rounds = 25;
    double damping = 1e-6;
    Linear now = at(knit);
    for (int round = 0; round < most_rounds; ++round) {
      Eigen::Matrix<double, fields, fields> matrix = now.information;
      matrix.diagonal() *= 1.0 + damping;
      const LatticeFields step = matrix.ldlt().solve(now.gradient);
      const LatticeFields next = lattice_fields(knit) + step;
      const bool sane = step.allFinite() && next[0] > 0.0 && next[1] > 0.0;
      const Knit<> moved = sane ? with_lattice_fields(knit, next) : knit;
      const Linear then = sane ? at(moved) : now;
      if (!sane || !(then.cost < now.cost)) {
        damping = std::max(1e-3, damping * 10.0);
        if (damping > 1e4) break;
        continue;
      }
      const double gain = (now.cost - then.cost) / now.cost;
      knit = moved;
      now = then;
      damping *= 0.1;
      if (gain < 1e-10) break;
    }
    return knit;
  }

  /// The sandwich: what the residuals of one block pull, squared and summed over the blocks.
  Eigen::Matrix<double, fields, fields> covariance(const Knit<>& knit, double courses) const {
    const Linear linear = at(knit);
    const Eigen::LLT<Eigen::MatrixXd> solver(linear.gram);
    std::vector<Eigen::MatrixXd> project;
    for (const auto& cross : linear.cross) project.push_back(solver.solve(cross));
    std::map<std::pair<int, int>, LatticeFields> pulls;
    for (int row = window.row; row < window.row + window.rows; ++row) {
      const RowEquations equations = row_at(knit, row);
      const Eigen::MatrixXd residuals = equations.values - equations.basis * linear.coefficients;
      Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(window.cols, fields);
      for (std::size_t p = 0; p < picture.planes.size(); ++p) {
        const Eigen::VectorXd coefficients = linear.coefficients.col(Eigen::Index(p));
        pull += residuals.col(Eigen::Index(p)).asDiagonal() *
                (slopes(equations, coefficients) - equations.basis * project[p]);
      }
      for (int c = 0; c < window.cols; ++c) {
        const std::pair block{int(std::floor(0.5 * equations.phases.cycles(c, 0))),
                              int(std::floor(0.5 * courses * equations.phases.cycles(c, 1)))};
        pulls.try_emplace(block, LatticeFields::Zero()).first->second += pull.row(c).transpose();
      }
    }
    Eigen::Matrix<double, fields, fields> meat = Eigen::Matrix<double, fields, fields>::Zero();
    for (const auto& [block, pull] : pulls) meat += pull * pull.transpose();
    const double blocks = double(pulls.size());
    // Numbers that were fitted make the pulls smaller than the errors they come from.
    const double correction = blocks / std::max(1.0, blocks - 2.0 * fields);
    const Eigen::Matrix<double, fields, fields> inverse = linear.information.inverse();
    return correction * inverse * meat * inverse;
  }
};

/// Peaks are placed to a part of a bin: the error of a mean over the whole picture.
Eigen::Matrix<double, fields, fields> covariance_of_peaks(const Knit<>& knit,
                                                          const Extent& extent) {
  constexpr double bins = 0.25;
  LatticeFields sigma = LatticeFields::Zero();
  sigma[0] = bins * knit.wale_mm * knit.wale_mm / extent.width();
  sigma[1] = bins * knit.course_mm * knit.course_mm / extent.height();
  sigma[2] = sigma[3] = bins * knit.course_mm / extent.width();
  // Gradients were not looked for: they may be what moves the stitches at the border by a half.
  sigma[4] = 4.0 * knit.wale_mm / (extent.width() * extent.width());
  sigma[5] = 4.0 * knit.course_mm / (extent.height() * extent.height());
  return sigma.cwiseAbs2().asDiagonal();
}

}  // namespace

LatticeFit fit_lattice(const KnitPicture& picture, const Knit<>& guess) {
  const int courses = std::clamp(int(std::lround(guess.course_mm / guess.wale_mm / 0.8)), 1, 8);
  LatticeProblem problem{picture, {}, {}};
  LatticeFit fit;
  fit.knit = guess;
  for (const double share : {0.5, 0.75, 1.0, 1.0}) {
    problem.window = middle_of(picture.extent, share);
    problem.harmonics = strongest(picture, problem.window, fit.knit, courses);
    fit.knit = problem.solved(fit.knit);
  }
  const Linear linear = problem.at(fit.knit);
  fit.explained = 1.0 - linear.cost / linear.variance;
  fit.covariance = problem.covariance(fit.knit, courses);
  if (fit.explained >= least_explained) return fit;
  fit.wanders = true;
  fit.knit = guess;
  fit.covariance = covariance_of_peaks(guess, picture.extent);
  return fit;
}

}  // namespace hada
