#include "fit/knit_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "fit/solve.h"
#include "mechanics/knit_newton.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

constexpr int most_parameters = 4;  // log ratio, continuity, log wale, log course
constexpr double exactness = 1e-9;  // of derivatives
constexpr double nowhere = 1e3;     // a residual where the knit does not come to rest, in wales
// Of a wale: no crossing is known better. What only smaller differences than this would tell is not
// told, even if they fit.
constexpr double least_noise = 1e-6;

const std::vector<SolverBounds> bounds{{std::log(1e-2), std::log(1e3)},
                                       {0.0, 0.95},
                                       {std::log(0.5), std::log(2.0)},
                                       {std::log(0.5), std::log(2.0)}};

// A knit and how it is held, as a function of the parameters.
class PulledModel {
 public:
  PulledModel(const KnitNet& net, const std::vector<int>& repeat, KnitClamp clamp,
              const std::vector<KnitState>& states, int parameters)
      : rest_(net), repeat_(repeat), states_(states), parameters_(parameters) {
    rest_.stiffness.assign(std::size_t(net.courses), 1.0);
    for (const KnitState& state : states) {
      const auto knit = pulled(rest_, state.pull, clamp, state.stretch);
      pins_.push_back(knit.net.pinned);
      last_.push_back(knit.start);
      start_.push_back(knit.start);
      for (int i = 0; i < net.points(); ++i) residuals_ += knit.net.is_pinned(i) ? 0 : 2;
    }
  }

  int residuals() const { return residuals_; }

  KnitNet net(const double* p, std::size_t state) const {
    KnitNet net = rest_;
    net.stiffness = stiffness_of_courses(net.courses, std::exp(p[0]), repeat_);
    net.continuity = p[1];
    if (parameters_ > 2) net.wale_length *= std::exp(p[2]), net.course_length *= std::exp(p[3]);
    net.pinned = pins_[state];
    return net;
  }

  // The places at rest; they are sought from where they were last, then from an even stretch.
  const Places* at_rest(const KnitNet& net, std::size_t state) {
    for (const Places* start : {&last_[state], &start_[state]}) {
      KnitAtRest rest = knit_at_rest(net, *start, {.tolerance = 1e-8});
      if (!rest.settled) continue;
      last_[state] = std::move(rest.places);
      return &last_[state];
    }
    return nullptr;
  }

  /// Fills (places - seen) / wale of the free crossings, and their derivatives.
  void evaluate(const double* p, double* residuals, double* jacobian) {
    int row = 0;
    for (std::size_t s = 0; s < states_.size(); ++s) {
      const KnitNet held = net(p, s);
      const Places* places = at_rest(held, s);
      std::vector<Places> slopes;
      if (places && jacobian) slopes = derivatives(held, *places);
      for (int i = 0; i < held.points(); ++i) {
        if (held.is_pinned(i)) continue;
        const auto at = std::size_t(i);
        for (int axis = 0; axis < 2; ++axis, ++row) {
          residuals[row] =
              places ? ((*places)[at][axis] - states_[s].places[at][axis]) / rest_.wale_length
                     : nowhere;
          for (int k = 0; jacobian && k < parameters_; ++k) {
            jacobian[row * parameters_ + k] =
                places ? slopes[std::size_t(k)][at][axis] / rest_.wale_length : 0.0;
          }
        }
      }
    }
  }

  /// The first state in which the knit does not come to rest, or how many there are.
  std::size_t restless(const double* p) {
    std::size_t state = 0;
    while (state < states_.size() && at_rest(net(p, state), state)) ++state;
    return state;
  }

  /// How far clamped crossings were seen from where the stretch puts them, in wales, root mean
  /// square.
  double clamps_off(std::size_t state) const {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < start_[state].size(); ++i) {
      if (!pins_[state][i]) continue;
      sum += (states_[state].places[i] - start_[state][i]).squaredNorm();
      count += 1.0;
    }
    return std::sqrt(sum / std::max(count, 1.0)) / rest_.wale_length;
  }

  /// The force on one edge's clamps in a state, along the pull, for nylon of k = 1: the mean of
  /// both.
  double load(const double* p, std::size_t state) {
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

 private:
  // dx/dp for each parameter, from J dx/dp = -dF/dp.
  std::vector<Places> derivatives(const KnitNet& net, const Places& places) const {
    const KnitSprings springs = springs_of(net, places);
    const KnitFrames frames{2, {places.size(), Eigen::Matrix3d(Eigen::Matrix3d::Identity())}};
    KnitNewton newton(net, 2);
    std::vector<Places> slopes;
    for (int k = 0; k < parameters_; ++k) {
      Places load = k == 1 ? continuity_forces(net, springs)
                           : forces(net, with_slopes_of_tension(net, springs, k));
      for (auto& f : load) f = -f;
      slopes.push_back(newton.step(net, springs, frames, load, exactness));
    }
    return slopes;
  }

  // The springs with the derivative of their tension in its place; forces are linear in it.
  KnitSprings with_slopes_of_tension(const KnitNet& net, KnitSprings springs, int parameter) const {
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

  KnitNet rest_;
  std::vector<int> repeat_;
  const std::vector<KnitState>& states_;
  int parameters_;
  int residuals_ = 0;
  std::vector<std::vector<bool>> pins_;
  std::vector<Places> start_, last_;
};

void check(const KnitNet& net, const std::vector<int>& repeat,
           const std::vector<KnitState>& states) {
  if (states.empty()) throw Error("stiffness needs crossings of one state of pull at least");
  bool nylon = false, support = false;
  for (int j = 0; j < net.courses && !repeat.empty(); ++j) {
    (repeat[std::size_t(j) % repeat.size()] != 0 ? support : nylon) = true;
  }
  if (!nylon || !support) {
    throw Error("a ratio of stiffness needs courses of two yarns: 0 and 1 in \"repeat\"");
  }
  for (const KnitState& state : states) {
    if (state.places.size() != std::size_t(net.points())) {
      throw Error("every state needs a place for each crossing of the knit");
    }
    // What is further out than the knit is long was seen in another frame, or not at all.
    const double farthest = 100.0 * state.stretch * (net.wales + net.courses) *
                            std::max(net.wale_length, net.course_length);
    for (const auto& place : state.places) {
      if (!(place.cwiseAbs().maxCoeff() < farthest)) {
        throw Error("a crossing lies far outside the knit: give places in mm, about its middle");
      }
    }
  }
}

Eigen::MatrixXd information_at(PulledModel& model, const std::vector<double>& p) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor jacobian(model.residuals(), Eigen::Index(p.size()));
  std::vector<double> residuals(std::size_t(model.residuals()));
  model.evaluate(p.data(), residuals.data(), jacobian.data());
  return jacobian.transpose() * jacobian;
}

void add_remarks(KnitStiffness& found, KnitClamp clamp, const PulledModel& model,
                 const std::vector<KnitState>& states, const std::vector<double>& p) {
  for (std::size_t s = 0; s < states.size(); ++s) {
    constexpr double most_off = 0.05;  // of a wale: more is no noise of a picture
    const double off = model.clamps_off(s);
    if (off < std::max(most_off, 4.0 * least_noise)) continue;
    found.remarks.push_back(
        fmt::format("the clamped crossings of state {} lie {:.2g} wales from where a stretch of "
                    "{:g} puts them: "
                    "check the stretch, and that places count from the middle of the knit",
                    s + 1, off, states[s].stretch));
  }
  const char* const names[] = {"stiffness ratio", "yarn coefficient", "wale", "course"};
  for (std::size_t k = 0; k < p.size(); ++k) {
    constexpr double near = 1e-6;
    if (p[k] > bounds[k].low + near && p[k] < bounds[k].high - near) continue;
    found.remarks.push_back(
        fmt::format("the {} lies on its bound: its sigma means nothing", names[k]));
  }
  const bool loose_ratio = found.log_ratio_sigma > 0.3,
             loose_coefficient = found.continuity.sigma > 0.1;
  if (loose_ratio) found.remarks.push_back("these states hardly tell the stiffness ratio");
  if (loose_coefficient) found.remarks.push_back("these states hardly tell the yarn coefficient");
  if ((loose_ratio || loose_coefficient) && clamp == KnitClamp::uniform) {
    found.remarks.push_back(
        "uniform clamps pulled along the wales tell the ratio alone, along the courses the "
        "coefficient alone; three-point clamps tell both");
  }
  if (!found.nylon_N_per_mm) {
    found.remarks.push_back(
        "the shape is the same for all stiffnesses times a factor: give the load on the clamps to "
        "know them in N/mm");
  }
}

}  // namespace

KnitStiffness knit_stiffness(const KnitNet& net, const std::vector<int>& repeat, KnitClamp clamp,
                             const std::vector<KnitState>& states,
                             const KnitStiffnessOptions& options) {
  check(net, repeat, states);
  const int parameters = options.lengths_known ? 2 : most_parameters;
  const std::vector<SolverBounds> free(bounds.begin(), bounds.begin() + parameters);
  KnitStiffness found;
  Ending best;
  for (const double ratio : {2.0, 8.0, 30.0}) {
    // Each start remembers its own places, so that what it finds does not hang on the others.
    PulledModel model(net, repeat, clamp, states, parameters);
    std::vector<double> start{std::log(ratio), 0.15, 0.0, 0.0};
    start.resize(std::size_t(parameters));
    const auto ending =
        descend({start}, free, model.residuals(),
                [&](const double* p, double* r, double* j) { model.evaluate(p, r, j); },
                {.max_iterations = 60, .tolerance = 1e-9})[0];
    ++found.starts;
    const double same = 1e-4 * std::max(best.cost, 1e-12);
    found.agreeing =
        ending.cost < best.cost - same ? 1 : found.agreeing + (ending.cost < best.cost + same);
    if (ending.cost < best.cost) best = ending;
  }
  PulledModel model(net, repeat, clamp, states, parameters);
  const auto& p = best.packed;
  if (const std::size_t state = best.packed.empty() ? 0 : model.restless(p.data());
      best.packed.empty() || state < states.size()) {
    throw Error(fmt::format(
        "the knit of state {} does not come to rest: check its stretch and clamps", state + 1));
  }
  const double variance = std::max(2.0 * best.cost / std::max(model.residuals() - parameters, 1),
                                   least_noise * least_noise);
  const Eigen::MatrixXd covariance =
      variance * covariance_of(information_at(model, p), std::vector<bool>(p.size(), true));
  const auto sigma = [&](int k) { return std::sqrt(covariance(k, k)); };
  found.log_ratio_sigma = sigma(0);
  found.ratio = {std::exp(p[0]), std::exp(p[0]) * sigma(0)};
  found.continuity = {p[1], sigma(1)};
  found.wale_mm = {net.wale_length, 0.0}, found.course_mm = {net.course_length, 0.0};
  if (parameters > 2) {
    found.wale_mm = {net.wale_length * std::exp(p[2]), net.wale_length * std::exp(p[2]) * sigma(2)};
    found.course_mm = {net.course_length * std::exp(p[3]),
                       net.course_length * std::exp(p[3]) * sigma(3)};
  }
  found.noise_mm = std::sqrt(variance) * net.wale_length;
  if (options.load_N) {
    const std::size_t last = states.size() - 1;
    const double load = model.load(p.data(), last);
    if (!(load > 0.0)) {
      throw Error(
          "the last state pulls at no clamp: a load says nothing of a knit at its own length");
    }
    Eigen::VectorXd slope(parameters);
    for (int k = 0; k < parameters; ++k) {
      auto ahead = p;
      const double step = 1e-3;
      ahead[std::size_t(k)] += step;
      slope[k] = (model.load(ahead.data(), last) - load) / (step * load);
    }
    const double k = *options.load_N / load;
    found.nylon_N_per_mm = Found{k, k * std::sqrt(std::max(slope.dot(covariance * slope), 0.0))};
  }
  add_remarks(found, clamp, model, states, p);
  return found;
}

std::array<double, 2> stiffness_bounds(const KnitNet& net, const std::vector<int>& repeat,
                                       KnitClamp clamp, const std::vector<KnitState>& states,
                                       double ratio, double noise_mm) {
  check(net, repeat, states);
  PulledModel model(net, repeat, clamp, states, 2);
  const Eigen::MatrixXd covariance =
      covariance_of(information_at(model, {std::log(ratio), net.continuity}), {true, true});
  const double noise = noise_mm / net.wale_length;
  return {noise * std::sqrt(covariance(0, 0)), noise * std::sqrt(covariance(1, 1))};
}

}  // namespace hada
