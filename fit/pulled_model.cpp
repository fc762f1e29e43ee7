#include "fit/pulled_model.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "mechanics/knit_newton.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double exactness = 1e-9;  // of derivatives
constexpr double nowhere = 1e3;     // a residual where the knit does not come to rest, in wales

/// The crossings as they were seen, in the frame that the clamped ones tell, where `knit` starts: a
/// wide knit has several rests, and theirs is the one that counts. Those that were not seen start
/// where `knit` does, and so do all if the clamps are not seen where they should be.
Places seen_from_clamps(const PulledKnit& knit, const Places& seen, double wale_length) {
  constexpr double most_off = 0.3;  // of a wale
  // start = (a, -b; b, a) seen + (x, y)
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const auto rows = [&](std::size_t i) {
    Eigen::Matrix<double, 2, 4> r;
    r << seen[i].x(), -seen[i].y(), 1.0, 0.0, seen[i].y(), seen[i].x(), 0.0, 1.0;
    return r;
  };
  const auto is_known = [&](std::size_t i) {
    return knit.net.is_pinned(int(i)) && seen[i].allFinite();
  };
  int known = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!is_known(i)) continue;
    gram += rows(i).transpose() * rows(i);
    right += rows(i).transpose() * knit.start[i].head<2>();
    ++known;
  }
  if (known < 3) return knit.start;
  const Eigen::Vector4d frame = gram.ldlt().solve(right);
  double off = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (is_known(i)) off += (rows(i) * frame - knit.start[i].head<2>()).squaredNorm() / known;
  }
  if (!(std::sqrt(off) < most_off * wale_length)) return knit.start;
  Places places = knit.start;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (knit.net.is_pinned(int(i)) || !seen[i].allFinite()) continue;
    places[i].head<2>() = rows(i) * frame;
  }
  return places;
}

}  // namespace

PulledModel::PulledModel(const KnitNet& net, const std::vector<int>& repeat, KnitClamp clamp,
                         const std::vector<KnitState>& states, const KnitStiffnessOptions& options)
    : rest_(net),
      repeat_(repeat),
      states_(states),
      springs_(options.lengths_known ? 2 : 4),
      framed_(!options.frame_known) {
  rest_.stiffness.assign(std::size_t(net.courses), 1.0);
  for (std::size_t s = 0; s < states.size(); ++s) {
    const auto knit = pulled(rest_, states[s].pull, clamp, states[s].stretch);
    pins_.push_back(knit.net.pinned);
    start_.push_back(knit.start);
    last_.push_back(knit.start);
    seen_.push_back(seen_from_clamps(knit, states[s].places, net.wale_length));
    for (std::size_t i = 0; i < knit.start.size(); ++i) residuals_ += counts(s, i) ? 2 : 0;
  }
}

// Those that are held tell only of the frame.
bool PulledModel::counts(std::size_t state, std::size_t point) const {
  return states_[state].places[point].allFinite() && (framed_ || !pins_[state][point]);
}

KnitNet PulledModel::net(const double* p, std::size_t state) const {
  KnitNet net = rest_;
  net.stiffness = stiffness_of_courses(net.courses, std::exp(p[0]), repeat_);
  net.continuity = p[1];
  if (springs_ > 2) net.wale_length *= std::exp(p[2]), net.course_length *= std::exp(p[3]);
  net.pinned = pins_[state];
  return net;
}

PulledModel::Frame PulledModel::frame(const double* p, std::size_t state) const {
  if (!framed_) return {};
  const double* f = p + springs_ + frame_size * int(state);
  return {f[0], f[1], f[2], f[3]};
}

// The places at rest; they are sought from where they were seen, from where they were last, then
// from an even stretch.
const Places* PulledModel::at_rest(const KnitNet& net, std::size_t state) {
  for (const Places* start : {&seen_[state], &last_[state], &start_[state]}) {
    KnitAtRest rest = knit_at_rest(net, *start, {.tolerance = 1e-8});
    if (!rest.settled) continue;
    last_[state] = std::move(rest.places);
    return &last_[state];
  }
  return nullptr;
}

void PulledModel::evaluate(const double* p, double* residuals, double* jacobian) {
  const int columns = parameters();
  if (jacobian) std::fill_n(jacobian, residuals_ * columns, 0.0);
  int row = 0;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const KnitNet held = net(p, s);
    const Places* places = at_rest(held, s);
    std::vector<Places> slopes;
    if (places && jacobian) slopes = derivatives(held, *places);
    const Frame f = frame(p, s);
    for (std::size_t i = 0; i < start_[s].size(); ++i) {
      if (!counts(s, i)) continue;
      Vector2d off = Vector2d::Constant(nowhere);
      if (places) {
        off = (f.turned((*places)[i]) - states_[s].places[i].head<2>()) / rest_.wale_length +
              Vector2d(f.x, f.y);
      }
      for (int axis = 0; axis < 2; ++axis, ++row) {
        residuals[row] = off[axis];
        if (!jacobian || !places) continue;
        double* line = jacobian + row * columns;
        for (int k = 0; k < springs_; ++k) {
          line[k] = f.turned(slopes[std::size_t(k)][i])[axis] / rest_.wale_length;
        }
        if (!framed_) continue;
        double* of_frame = line + springs_ + frame_size * int(s);
        const Vector3d& at = (*places)[i];
        of_frame[0] = at[axis] / rest_.wale_length;
        of_frame[1] = (axis == 0 ? -at.y() : at.x()) / rest_.wale_length;
        of_frame[2 + axis] = 1.0;
      }
    }
  }
}

std::size_t PulledModel::restless(const double* p) {
  std::size_t state = 0;
  while (state < states_.size() && at_rest(net(p, state), state)) ++state;
  return state;
}

double PulledModel::clamps_off(const double* p, std::size_t state) const {
  const Frame f = frame(p, state);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < start_[state].size(); ++i) {
    if (!pins_[state][i] || !states_[state].places[i].allFinite()) continue;
    const Vector2d off = f.turned(start_[state][i]) + rest_.wale_length * Vector2d(f.x, f.y) -
                         states_[state].places[i].head<2>();
    sum += off.squaredNorm(), count += 1.0;
  }
  return std::sqrt(sum / std::max(count, 1.0)) / rest_.wale_length;
}

double PulledModel::load(const double* p, std::size_t state) {
  const KnitNet held = net(p, state);
  const Places* places = at_rest(held, state);
  if (!places) return NAN;
  const Places force = forces(held, springs_of(held, *places));
  const int axis = states_[state].pull == KnitPull::course ? 0 : 1;
  double sum = 0.0;
  for (int i = 0; i < held.points(); ++i) {
    if (held.is_pinned(i)) sum += 0.5 * std::abs(force[std::size_t(i)][axis]);
  }
  return sum;
}

Eigen::MatrixXd PulledModel::information(const std::vector<double>& p) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor jacobian(residuals_, parameters());
  std::vector<double> residuals(static_cast<std::size_t>(residuals_));
  evaluate(p.data(), residuals.data(), jacobian.data());
  return jacobian.transpose() * jacobian;
}

std::vector<Places> PulledModel::derivatives(const KnitNet& net, const Places& places) const {
  const KnitSprings springs = springs_of(net, places);
  const KnitFrames frames{2, {places.size(), Eigen::Matrix3d(Eigen::Matrix3d::Identity())}};
  KnitNewton newton(net, 2);
  std::vector<Places> slopes;
  for (int k = 0; k < springs_; ++k) {
    Places load = k == 1 ? continuity_forces(net, springs)
                         : forces(net, with_slopes_of_tension(net, springs, k));
    for (auto& f : load) f = -f;
    slopes.push_back(newton.step(net, springs, frames, load, exactness));
  }
  return slopes;
}

// The springs with the derivative of their tension in its place; forces are linear in it.
KnitSprings PulledModel::with_slopes_of_tension(const KnitNet& net, KnitSprings springs,
                                                int parameter) const {
  for (std::size_t i = 0; i < springs.along.size(); ++i) {
    const auto course = i / std::size_t(net.wales);
    const double k = net.stiffness[course];
    const double share = repeat_[course % repeat_.size()] != 0 ? 1.0 : 0.0;
    double& along = springs.along_tension[i];
    double& up = springs.up_tension[i];
    // d tension / d log ratio = tension of support yarn; d / d log length = -k length.
    along = parameter == 0 ? share * along : parameter == 2 ? -k * net.wale_length : 0.0;
    up = parameter == 0 ? share * up : parameter == 3 ? -k * net.course_length : 0.0;
  }
  return springs;
}

}  // namespace hada
