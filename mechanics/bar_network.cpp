#include "mechanics/bar_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

namespace hada {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

// One residual and how it changes with the points that it knows.
struct Term {
  std::array<int, 4> points{};
  int count = 0;
  double residual = 0.0;
  std::array<Vector3d, 4> slopes;
};

const Vector3d& at(const Places& places, int i) {
  return places[std::size_t(i)];
}

Term bar_term(const Bar& bar, double weight, const Places& places) {
  const Vector3d way = at(places, bar.to) - at(places, bar.from);
  const double length = std::max(way.norm(), 1e-300);
  Term term;
  term.points = {bar.from, bar.to, 0, 0};
  term.count = 2;
  term.residual = weight * (length - bar.length);
  term.slopes[1] = weight * way / length;
  term.slopes[0] = -term.slopes[1];
  return term;
}

// The distance from a plane, times the area of the three points over that at rest.
Term plane_term(const std::array<int, 4>& plane, double weight, const Places& places) {
  const Vector3d &a = at(places, plane[0]), &b = at(places, plane[1]), &c = at(places, plane[2]),
                 &p = at(places, plane[3]);
  const Vector3d u = b - a, v = c - a, w = p - a;
  const double scale = weight / std::max(u.cross(v).norm(), 1e-300);
  Term term;
  term.points = plane;
  term.count = 4;
  term.residual = scale * u.cross(v).dot(w);
  term.slopes[1] = scale * v.cross(w);
  term.slopes[2] = scale * w.cross(u);
  term.slopes[3] = scale * u.cross(v);
  term.slopes[0] = -(term.slopes[1] + term.slopes[2] + term.slopes[3]);
  return term;
}

// Source of the slopes: Bridson, Marino, Fedkiw, Simulation of clothing with folds, SCA 2003.
Term hinge_term(const Hinge& hinge, double weight, double last, const Places& places) {
  const Vector3d &a = at(places, hinge.from), &b = at(places, hinge.to);
  const Vector3d along = b - a, to_left = at(places, hinge.left) - a,
                 to_right = at(places, hinge.right) - a;
  const double square = along.squaredNorm(), length = std::sqrt(square);
  const Vector3d up_left = along.cross(to_left), up_right = to_right.cross(along);
  const Vector3d left = up_left * (length / std::max(up_left.squaredNorm(), 1e-300));
  const Vector3d right = up_right * (length / std::max(up_right.squaredNorm(), 1e-300));
  const double s = to_left.dot(along) / square, t = to_right.dot(along) / square;
  // A fold that is pressed flat may pass half a turn: stay on the side where it was.
  constexpr double turn = 2.0 * std::numbers::pi;
  double angle = hinge_angle(hinge, places);
  angle += turn * std::round((last - angle) / turn);
  Term term;
  term.points = {hinge.left, hinge.right, hinge.from, hinge.to};
  term.count = 4;
  term.residual = weight * (angle - hinge.angle);
  term.slopes = {weight * left, weight * right, -weight * ((1.0 - s) * left + (1.0 - t) * right),
                 -weight * (s * left + t * right)};
  return term;
}

Term corner_term(const Corner& corner, const Places& places) {
  const Vector3d u = at(places, corner.from) - at(places, corner.at);
  const Vector3d v = at(places, corner.to) - at(places, corner.at);
  const Vector3d across = u.cross(v);
  const double area = std::max(across.norm(), 1e-300), weight = std::sqrt(corner.stiffness);
  Term term;
  term.points = {corner.at, corner.from, corner.to, 0};
  term.count = 3;
  term.residual = weight * (std::atan2(area, u.dot(v)) - corner.angle);
  term.slopes[1] = weight * u.cross(across) / (area * std::max(u.squaredNorm(), 1e-300));
  term.slopes[2] = weight * across.cross(v) / (area * std::max(v.squaredNorm(), 1e-300));
  term.slopes[0] = -(term.slopes[1] + term.slopes[2]);
  return term;
}

// How strongly each kind of residual counts.
struct Weights {
  double bars = 1.0;  // times the root of each bar's stiffness
  double planes = 1.0;
  bool hinges = true;
};

}  // namespace

double hinge_angle(const Hinge& hinge, const Places& places) {
  const Vector3d& a = at(places, hinge.from);
  const Vector3d along = (at(places, hinge.to) - a).normalized();
  const Vector3d left = along.cross(at(places, hinge.left) - a);
  const Vector3d right = (at(places, hinge.right) - a).cross(along);
  return std::atan2(right.cross(left).dot(along), left.dot(right));
}

class Relaxation::Descent {
 public:
  explicit Descent(BarNetwork network) : network_(std::move(network)) {}

  const BarNetwork& network() const { return network_; }

  void begin(Places start, double size, bool hinges) {
    places_ = std::move(start);
    size_ = size;
    angles_.clear();
    for (const Hinge& hinge : network_.hinges) angles_.push_back(hinge_angle(hinge, places_));
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      // A fold that lies flat on itself belongs to the side that it should be on.
      const bool shut = std::abs(angles_[i]) > 0.999 * std::numbers::pi;
      if (shut && angles_[i] * network_.hinges[i].angle < 0.0) {
        angles_[i] -= std::copysign(2.0 * std::numbers::pi, angles_[i]);
      }
    }
    if (matrix_.rows() == 0) lay_pattern(hinges);
  }

  // returns  the number of steps
  int run(const Weights& weights, int most_steps, double tolerance) {
    double damping = 1e-6;
    double energy = gather(weights, places_);
    int steps = 0;
    while (steps < most_steps) {
      ++steps;
      assemble();
      const double mean = matrix_.diagonal().sum() / double(matrix_.rows());
      for (int i = 0; i < matrix_.rows(); ++i) {
        matrix_.coeffRef(i, i) += damping * mean + (free_[std::size_t(i)] ? 0.0 : 1e12 * mean);
      }
      solver_.factorize(matrix_);
      const Eigen::VectorXd step = solver_.solve(-slope_);
      if (solver_.info() != Eigen::Success || !step.allFinite()) {
        damping = std::max(10.0 * damping, 1e-12);
        if (damping > 1e6) break;
        energy = gather(weights, places_);
        continue;
      }
      Places next = places_;
      for (std::size_t i = 0; i < next.size(); ++i) {
        if (free_[3 * i]) next[i] += step.segment<3>(3 * int(i));
      }
      const double length = step.lpNorm<Eigen::Infinity>();
      const double trial = gather(weights, next);
      if (trial <= energy) {
        places_ = std::move(next);
        energy = trial;
        damping = std::max(damping * 0.2, 1e-11);
        keep_angles();
        if (length < tolerance * size_) break;
      } else {
        damping = std::max(8.0 * damping, 1e-12);
        energy = gather(weights, places_);
        if (damping > 1e8 || length < 1e-3 * tolerance * size_) break;
      }
    }
    return steps;
  }

  Places take() { return std::move(places_); }
  const Places& places() const { return places_; }

 private:
  double gather(const Weights& weights, const Places& places) {
    terms_.clear();
    for (const Bar& bar : network_.bars) {
      terms_.push_back(bar_term(bar, weights.bars * std::sqrt(bar.stiffness), places));
    }
    for (const auto& plane : network_.planes) {
      terms_.push_back(plane_term(plane, weights.planes, places));
    }
    for (std::size_t i = 0; weights.hinges && i < network_.hinges.size(); ++i) {
      const Hinge& hinge = network_.hinges[i];
      terms_.push_back(hinge_term(hinge, std::sqrt(hinge.stiffness), angles_[i], places));
    }
    for (std::size_t i = 0; weights.hinges && i < network_.corners.size(); ++i) {
      terms_.push_back(corner_term(network_.corners[i], places));
    }
    double energy = 0.0;
    for (const Term& term : terms_) energy += term.residual * term.residual;
    return energy;
  }

  void keep_angles() {
    constexpr double turn = 2.0 * std::numbers::pi;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double angle = hinge_angle(network_.hinges[i], places_);
      angles_[i] = angle + turn * std::round((angles_[i] - angle) / turn);
    }
  }

  // Which entries of the matrix a term touches never changes: they are looked up once.
  void lay_pattern(bool hinges) {
    const int n = 3 * int(places_.size());
    free_.assign(std::size_t(n), true);
    for (int i = 0; i < n && !network_.pinned.empty(); ++i) {
      free_[std::size_t(i)] = !network_.pinned[std::size_t(i / 3)];
    }
    gather({1.0, 1.0, hinges}, places_);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 0.0);
    const auto visit = [&](const auto& entry) {
      for (const Term& term : terms_) {
        for (int p = 0; p < term.count; ++p) {
          for (int q = 0; q < term.count; ++q) {
            const int row = 3 * term.points[std::size_t(p)], col = 3 * term.points[std::size_t(q)];
            if (row < col) continue;
            for (int i = 0; i < 3; ++i) {
              for (int j = 0; j < 3; ++j) entry(row + i, col + j);
            }
          }
        }
      }
    };
    visit([&](int row, int col) {
      if (row >= col) entries.emplace_back(row, col, 0.0);
    });
    matrix_.resize(n, n);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    matrix_.makeCompressed();
    visit([&](int row, int col) {
      slots_.push_back(row < col ? -1 : int(&matrix_.coeffRef(row, col) - matrix_.valuePtr()));
    });
    solver_.analyzePattern(matrix_);
    slope_.resize(n);
  }

  void assemble() {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    slope_.setZero();
    double* const values = matrix_.valuePtr();
    std::size_t slot = 0;
    for (const Term& term : terms_) {
      for (int p = 0; p < term.count; ++p) {
        const Vector3d& a = term.slopes[std::size_t(p)];
        slope_.segment<3>(3 * term.points[std::size_t(p)]) += term.residual * a;
        for (int q = 0; q < term.count; ++q) {
          if (term.points[std::size_t(p)] < term.points[std::size_t(q)]) continue;
          const Vector3d& b = term.slopes[std::size_t(q)];
          for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j, ++slot) {
              if (slots_[slot] >= 0) values[slots_[slot]] += a[i] * b[j];
            }
          }
        }
      }
    }
  }

  BarNetwork network_;
  Places places_;
  double size_ = 0.0;
  std::vector<double> angles_;  // of the hinges, followed over half turns
  std::vector<bool> free_;      // of the coordinates
  std::vector<Term> terms_;
  std::vector<int> slots_;
  Eigen::SparseMatrix<double> matrix_;  // its lower half
  Eigen::VectorXd slope_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
};

Relaxation::Relaxation(BarNetwork network, const RelaxOptions& options)
    : descent_(std::make_unique<Descent>(std::move(network))), options_(options) {}
Relaxation::Relaxation(Relaxation&&) noexcept = default;
Relaxation& Relaxation::operator=(Relaxation&&) noexcept = default;
Relaxation::~Relaxation() = default;

Relaxed Relaxation::from(Places start) {
  const BarNetwork& network = descent_->network();
  double size = 0.0, stiffest = 0.0, softest = 1e300;
  for (const Bar& bar : network.bars) {
    size = std::max(size, bar.length);
    softest = std::min(softest, bar.stiffness);
  }
  for (const Hinge& hinge : network.hinges) stiffest = std::max(stiffest, hinge.stiffness);
  descent_->begin(std::move(start), size, stiffest > 0.0 || !options_.rigid);
  Relaxed result;
  if (options_.rigid) {
    // All at once would make a valley too narrow and bent to follow.
    const double hinges = std::sqrt(std::max(stiffest, 1e-300)) / size;
    for (const double stiffer : {30.0, 1e3, 1e4}) {  // of the residuals; energies go by the square
      if (stiffest <= 0.0) break;
      const Weights weights{stiffer * hinges / std::sqrt(softest), stiffer * hinges, true};
      result.steps += descent_->run(weights, options_.most_steps, options_.tolerance);
    }
    // The descent converges by squares: after a step of 1e-9 what is left is rounding.
    result.steps +=
        descent_->run({1.0 / std::sqrt(softest), 1.0, false}, options_.most_steps, 1e-9);
  } else {
    const double planes = 1e3 * std::sqrt(softest);
    result.steps = descent_->run({1.0, planes, true}, options_.most_steps, options_.tolerance);
  }
  for (const Bar& bar : network.bars) {
    const Term term = bar_term(bar, 1.0, descent_->places());
    result.strain = std::max(result.strain, std::abs(term.residual) / bar.length);
  }
  for (const auto& plane : network.planes) {
    const Term term = plane_term(plane, 1.0, descent_->places());
    result.planarity = std::max(result.planarity, std::abs(term.residual) / size);
  }
  result.places = descent_->take();
  return result;
}

Relaxed relax(const BarNetwork& network, Places start, const RelaxOptions& options) {
  return Relaxation(network, options).from(std::move(start));
}

}  // namespace hada
