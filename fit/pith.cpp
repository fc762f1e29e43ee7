#include "fit/pith.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double wanted_directions = 8000.0;
constexpr double least_coherence = 0.35;
constexpr double loss_rad = 0.10;        // angles beyond are taken for cracks, rays and knots
constexpr double oval_prior = 0.05;      // a typical oval
constexpr double farthest = 30.0;        // pith, in picture diagonals: beyond, rings are straight
constexpr int descents = 8;              // of the best starts
constexpr std::size_t fewest_near = 60;  // directions that a surrounding must hold

/// Angle from the direction that `pith` and an oval make us expect to the normal that is seen.
/// ln rho = ln r + ln f(theta): its gradient leans from the radius by atan(f' / f).
double lean(const RingDirection& seen, const Eigen::Vector4d& state) {
  const Eigen::Vector2d outward = (seen.place - state.head<2>()).normalized();
  const double c = outward.x() * outward.x() - outward.y() * outward.y();  // of twice the angle
  const double s = 2.0 * outward.x() * outward.y();
  const Eigen::Vector2d turn =
      Eigen::Vector2d(1.0 + state[2] * c + state[3] * s, 2.0 * (state[3] * c - state[2] * s))
          .normalized();
  const Eigen::Vector2d expected(outward.x() * turn.x() - outward.y() * turn.y(),
                                 outward.x() * turn.y() + outward.y() * turn.x());
  const double cross = expected.x() * seen.normal.y() - expected.y() * seen.normal.x();
  return std::asin(std::clamp(cross, -1.0, 1.0));
}

double robust_cost(const std::vector<RingDirection>& seen, const Eigen::Vector4d& state) {
  double sum = 0.0;
  for (const auto& one : seen) {
    const double angle = lean(one, state) / loss_rad;
    sum += one.weight * std::log1p(angle * angle);
  }
  return sum;
}

/// Iteratively reweighted Gauss-Newton; a step that does not help is halved.
Eigen::Vector4d descended(const std::vector<RingDirection>& seen, Eigen::Vector4d state, bool oval,
                          double diagonal) {
  double cost = robust_cost(seen, state);
  for (int round = 0; round < 40; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    const double step = 1e-4 * diagonal;
    for (const auto& one : seen) {
      const double angle = lean(one, state);
      const double weight = one.weight / (loss_rad * loss_rad + angle * angle);
      Eigen::Vector4d slope = Eigen::Vector4d::Zero();
      for (int k = 0; k < (oval ? 4 : 2); ++k) {
        Eigen::Vector4d moved = state;
        const double h = k < 2 ? step : 1e-4;
        moved[k] += h;
        slope[k] = (lean(one, moved) - angle) / h;
      }
      normal += weight * slope * slope.transpose();
      right -= weight * angle * slope;
    }
    for (int k = 2; k < 4; ++k) {
      normal(k, k) += oval ? 1.0 / (oval_prior * oval_prior) : 1.0;
      if (oval) right[k] -= state[k] / (oval_prior * oval_prior);
    }
    normal.diagonal() *= 1.0 + 1e-9;
    Eigen::Vector4d move = normal.ldlt().solve(right);
    if (!move.allFinite()) break;
    const double reach = move.head<2>().norm();
    const double most = 0.5 * diagonal + 0.3 * state.head<2>().norm();
    if (reach > most) move *= most / reach;
    bool better = false;
    for (int halving = 0; halving < 6 && !better; ++halving, move *= 0.5) {
      const Eigen::Vector4d next = state + move;
      const double next_cost = robust_cost(seen, next);
      if (next_cost < cost && next.head<2>().norm() < farthest * diagonal) {
        better = true;
        state = next;
        cost = next_cost;
      }
    }
    if (!better || move.head<2>().norm() < 1e-6 * diagonal) break;
  }
  return state;
}

std::vector<RingDirection> thinned(const std::vector<RingDirection>& seen, std::size_t most) {
  const std::size_t stride = std::max<std::size_t>(1, seen.size() / most);
  std::vector<RingDirection> kept;
  for (std::size_t i = 0; i < seen.size(); i += stride) kept.push_back(seen[i]);
  return kept;
}

/// Starts on rings around the picture and on a lattice over it.
std::vector<Eigen::Vector4d> starts_around(const Extent& extent) {
  std::vector<Eigen::Vector4d> starts;
  const double w = extent.width(), h = extent.height();
  constexpr int side = 9;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      starts.emplace_back(w * ((i + 0.5) / side - 0.5), h * ((j + 0.5) / side - 0.5), 0.0, 0.0);
    }
  }
  for (const double reach : {0.8, 1.4, 2.5, 5.0, 10.0}) {
    for (int k = 0; k < 24; ++k) {
      const double angle = M_PI * k / 12.0;
      starts.emplace_back(reach * w * std::cos(angle), reach * h * std::sin(angle), 0.0, 0.0);
    }
  }
  return starts;
}

std::vector<RingDirection> near(const std::vector<RingDirection>& seen,
                                const Eigen::Vector2d& place, double radius) {
  std::vector<RingDirection> kept;
  for (const auto& one : seen) {
    if ((one.place - place).norm() < radius) kept.push_back(one);
  }
  return kept;
}

}  // namespace

std::vector<RingDirection> ring_directions(const LineField& field, const Extent& extent) {
  const double area = double(extent.rows) * extent.cols;
  const int step = std::max(1, int(std::sqrt(area / wanted_directions)));
  std::vector<float> strengths;
  for (int row = step / 2; row < extent.rows; row += step) {
    for (int col = step / 2; col < extent.cols; col += step) {
      if (field.strength(row, col) > 0.0f) strengths.push_back(field.strength(row, col));
    }
  }
  std::vector<RingDirection> directions;
  if (strengths.empty()) return directions;
  const float faint = 0.3f * median(strengths);
  for (int row = step / 2; row < extent.rows; row += step) {
    for (int col = step / 2; col < extent.cols; col += step) {
      const double coherence = double(field.coherence(row, col));
      if (field.strength(row, col) <= faint || coherence < least_coherence) continue;
      const double angle = double(field.across(row, col));
      directions.push_back(
          {extent.place(row, col), {std::cos(angle), std::sin(angle)}, coherence * coherence});
    }
  }
  return directions;
}

PithGuess pith_guess(const std::vector<RingDirection>& directions, const Extent& extent) {
  if (directions.size() < fewest_directions) {
    throw Error("wood: no rings can be seen; give a sharp picture of an end grain");
  }
  const double diagonal = std::hypot(extent.width(), extent.height());
  const auto few = thinned(directions, 1500);
  std::vector<std::pair<double, Eigen::Vector4d>> ranked;
  for (const auto& start : starts_around(extent))
    ranked.emplace_back(robust_cost(few, start), start);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  ranked.resize(descents);
  for (auto& [cost, state] : ranked) {
    state = descended(few, state, false, diagonal);
    cost = robust_cost(few, state);
  }
  Eigen::Vector4d state =
      std::min_element(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
        return a.first < b.first;
      })->second;
  state = descended(directions, state, true, diagonal);

  auto surroundings = directions;
  const Eigen::Vector2d half(0.5 * extent.width(), 0.5 * extent.height());
  if ((state.head<2>().cwiseAbs() - half).maxCoeff() < 0.0) {
    for (double radius = 0.5 * half.minCoeff() * 2.0; radius > 0.1 * half.minCoeff();
         radius *= 0.7) {
      auto closer = near(directions, state.head<2>(), radius);
      if (closer.size() < fewest_near) break;
      surroundings = std::move(closer);
      state = descended(surroundings, state, true, diagonal);
    }
  }
  std::vector<double> leans;
  for (const auto& one : surroundings) leans.push_back(std::abs(lean(one, state)));
  return {state.head<2>(), median(leans), state[2], state[3]};
}

}  // namespace hada
