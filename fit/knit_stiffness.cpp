#include "fit/knit_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "core/error.h"
#include "fit/pulled_model.h"
#include "fit/solve.h"

namespace hada {
namespace {

// Of a wale: no crossing is known better. What only smaller differences than this would tell is not
// told, even if they fit.
constexpr double least_noise = 1e-6;

// Log ratio, continuity, log wale, log course.
const std::vector<SolverBounds> bounds{{std::log(1e-2), std::log(1e3)},
                                       {0.0, 0.95},
                                       {std::log(0.5), std::log(2.0)},
                                       {std::log(0.5), std::log(2.0)}};
// Of a frame: scale less one, turn, shift in wales.
const SolverBounds frame_bounds[] = {{-0.5, 0.5}, {-0.5, 0.5}, {-1e3, 1e3}, {-1e3, 1e3}};

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
      if (place.allFinite() && !(place.cwiseAbs().maxCoeff() < farthest)) {
        throw Error("a crossing lies far outside the knit: give places in mm, about its middle");
      }
    }
  }
}

void add_remarks(KnitStiffness& found, KnitClamp clamp, const PulledModel& model,
                 const std::vector<KnitState>& states, const std::vector<double>& p) {
  for (std::size_t s = 0; s < states.size(); ++s) {
    constexpr double most_off = 0.05;  // of a wale: more is no noise of a picture
    const double off = model.clamps_off(p.data(), s);
    if (off < std::max(most_off, 4.0 * least_noise)) continue;
    found.remarks.push_back(
        fmt::format("the clamped crossings of state {} lie {:.2g} wales from where a stretch of "
                    "{:g} puts them: "
                    "check the stretch, and that places count from the middle of the knit",
                    s + 1, off, states[s].stretch));
  }
  const char* const names[] = {"stiffness ratio", "yarn coefficient", "wale", "course"};
  for (std::size_t k = 0; k < std::size_t(model.springs()); ++k) {
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
  const PulledModel shape(net, repeat, clamp, states, options);
  const int parameters = shape.parameters();
  if (shape.residuals() <= parameters) {
    throw Error("too few crossings were seen to tell how stiff the yarns are");
  }
  std::vector<SolverBounds> free(bounds.begin(), bounds.begin() + shape.springs());
  while (int(free.size()) < parameters) free.insert(free.end(), frame_bounds, frame_bounds + 4);
  KnitStiffness found;
  Ending best;
  for (const double ratio : {2.0, 8.0, 30.0}) {
    // Each start remembers its own places, so that what it finds does not hang on the others.
    PulledModel model(net, repeat, clamp, states, options);
    std::vector<double> start{std::log(ratio), 0.15};
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
  PulledModel model(net, repeat, clamp, states, options);
  const auto& p = best.packed;
  if (const std::size_t state = best.packed.empty() ? 0 : model.restless(p.data());
      best.packed.empty() || state < states.size()) {
    throw Error(fmt::format(
        "the knit of state {} does not come to rest: check its stretch and clamps", state + 1));
  }
  const double variance = std::max(2.0 * best.cost / std::max(model.residuals() - parameters, 1),
                                   least_noise * least_noise);
  const Eigen::MatrixXd covariance =
      variance * covariance_of(model.information(p), std::vector<bool>(p.size(), true));
  const auto sigma = [&](int k) { return std::sqrt(covariance(k, k)); };
  found.log_ratio_sigma = sigma(0);
  found.ratio = {std::exp(p[0]), std::exp(p[0]) * sigma(0)};
  found.continuity = {p[1], sigma(1)};
  found.wale_mm = {net.wale_length, 0.0}, found.course_mm = {net.course_length, 0.0};
  if (!options.lengths_known) {
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

StiffnessBounds stiffness_bounds(const KnitNet& net, const std::vector<int>& repeat,
                                 KnitClamp clamp, const std::vector<KnitState>& states,
                                 double ratio, double noise_mm) {
  check(net, repeat, states);
  PulledModel model(net, repeat, clamp, states, {});
  const Eigen::MatrixXd information = model.information({std::log(ratio), net.continuity});
  const Eigen::MatrixXd covariance = covariance_of(information, {true, true});
  const double noise = noise_mm / net.wale_length;
  // What moves no crossing by a thousandth of its noise is rounding and the end of the search.
  constexpr double nothing = 1e-3;
  const Eigen::Vector2d told =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information).eigenvalues().cwiseMax(0.0);
  return {noise * std::sqrt(covariance(0, 0)), noise * std::sqrt(covariance(1, 1)),
          int((told.cwiseSqrt().array() > nothing * noise).count())};
}

}  // namespace hada
