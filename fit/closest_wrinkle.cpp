#include "fit/closest_wrinkle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "fit/further_noise.h"
#include "fit/solve.h"
#include "fit/spectral_distance.h"
#include "fit/wrinkle.h"

namespace hada {
namespace {

constexpr int most_functions = 5;
constexpr int most_rounds = 3;
constexpr std::size_t beam_width = 2;
constexpr double worth_it = 0.999;  // times the cost before

struct Nearest {
  Wrinkle<> wrinkle;
  double cost = HUGE_VAL;
};

double weighed(const Nearest& nearest) {
  return weighed(nearest.cost, nearest.wrinkle);
}

bool nearer(const Nearest& a, const Nearest& b) {
  return weighed(a) < weighed(b);
}

int functions(const Wrinkle<>& wrinkle) {
  return int(wrinkle.components.size() + wrinkle.repeated.size() + wrinkle.woven.size());
}

/// The search for the nearest, one noise function after the other.
class Search {
 public:
  Search(const Observation& seen, const FitProgress& progress)
      : seen_(seen),
        progress_(progress),
        distances_(spectral_distances(seen.square, seen.spectrum.independence)) {}

  const CellResiduals<LogDistance>& distances() const { return distances_; }

  /// Grown from nothing to `functions`, or to as many as pay for themselves.
  Nearest grown(int functions) const {
    const auto fainter = [](const Cell& a, const Cell& b) { return a.power < b.power; };
    Wrinkle<> bare;
    bare.components.clear();
    bare.floor_mm4 = std::min_element(seen_.square.begin(), seen_.square.end(), fainter)->power;
    std::vector<Nearest> beam{{bare}};
    for (int k = 1; k <= (functions > 0 ? functions : most_functions); ++k) {
      tell("nearest texture of " + std::to_string(k) + " noise functions");
      auto next = wider(beam, Seed(k));
      if (functions == 0 && k > 1 && criterion(next.front()) >= criterion(beam.front())) break;
      beam = std::move(next);
    }
    return beam.front();
  }

  /// Each noise function is taken out in turn and another sought, until none is better.
  Nearest with_others_in_turn(Nearest nearest) const {
    for (int round = 1; round <= most_rounds; ++round) {
      bool better = false;
      for (int k = 0; k < functions(nearest.wrinkle); ++k) {
        tell("noise function " + std::to_string(k + 1) + " once more, round " +
             std::to_string(round));
        Nearest other =
            with_one_more(without(nearest.wrinkle, k), weighed(nearest), mixed(Seed(k), round))
                .front();
        if (weighed(other) >= worth_it * weighed(nearest)) continue;
        nearest = std::move(other);
        better = true;
      }
      if (!better) break;
    }
    constexpr int to_the_end = 200;
    return descended(nearest, to_the_end);
  }

 private:
  void tell(const std::string& stage) const {
    if (progress_) progress_(stage);
  }

  /// All but one noise function.
  static Wrinkle<> without(Wrinkle<> wrinkle, int which) {
    const auto erased_from = [&](auto& list) {
      if (which >= 0 && which < int(list.size())) {
        list.erase(list.begin() + which);
        which = -1;
      } else {
        which -= int(list.size());
      }
    };
    erased_from(wrinkle.components);
    erased_from(wrinkle.repeated);
    erased_from(wrinkle.woven);
    return wrinkle;
  }

  Nearest descended(const Nearest& from, int iterations) const {
    const auto bounds = seen_bounds_of(from.wrinkle, seen_.spectrum.extent);
    const Ending ending = endings_of(std::vector{from.wrinkle}, bounds, distances_.count(),
                                     distances_, {.max_iterations = iterations, .tolerance = 1e-5})
                              .front();
    return {unpack(from.wrinkle, ending.packed.data()), ending.cost};
  }

  /// What is reached from `before` and one more noise function, the nearest first; those that are
  /// not going to be as near as `wanted` are left on the way.
  std::vector<Nearest> with_one_more(const Wrinkle<>& before, double wanted, Seed seed) const {
    constexpr int few = 8, enough = 25;
    constexpr double promising = 1.02;  // times the wanted cost, after a few iterations
    const auto starts = with_further_noise(before, seen_, seed);
    std::vector<Nearest> found(starts.size());
    for_each_index(int(starts.size()), [&](int i) {
      found[std::size_t(i)] = descended({starts[std::size_t(i)]}, few);
    });
    std::stable_sort(found.begin(), found.end(), nearer);
    for_each_index(int(std::min(found.size(), beam_width)), [&](int i) {
      Nearest& one = found[std::size_t(i)];
      if (weighed(one) < promising * wanted) one = descended(one, enough);
    });
    std::stable_sort(found.begin(), found.end(), nearer);
    return found;
  }

  /// The nearest with one more than those of `beam`, and the nearest that has another number of
  /// periods: what leads on is not always what is nearest now.
  std::vector<Nearest> wider(const std::vector<Nearest>& beam, Seed seed) const {
    std::vector<Nearest> next;
    for (const Nearest& one : beam)
      std::ranges::move(with_one_more(one.wrinkle, HUGE_VAL, seed), std::back_inserter(next));
    std::stable_sort(next.begin(), next.end(), nearer);
    const int of_nearest = periods(next.front().wrinkle);
    const auto other = std::find_if(next.begin(), next.end(), [&](const Nearest& one) {
      return periods(one.wrinkle) != of_nearest;
    });
    if (other != next.end()) std::swap(*other, next[1]);
    next.resize(std::min(next.size(), beam_width));
    return next;
  }

  /// Of Schwarz, where the scatter is not known.
  double criterion(const Nearest& nearest) const {
    const double cells = distances_.count();
    return cells * std::log(nearest.cost) + double(pack(nearest.wrinkle).size()) * std::log(cells);
  }

  const Observation& seen_;
  const FitProgress& progress_;
  CellResiduals<LogDistance> distances_;
};

}  // namespace

Fit<Wrinkle<>> closest_wrinkle(const Observation& seen, int functions,
                               const FitProgress& progress) {
  const Search search(seen, progress);
  const Nearest nearest = search.with_others_in_turn(search.grown(functions));
  Fit<Wrinkle<>> fit;
  fit.material = canonical(nearest.wrinkle);
  fit.cost = nearest.cost;
  fit.starts = fit.agreeing = 1;  // a search, not descents that could agree
  fit.runner_up_gap = HUGE_VAL;
  const auto& distances = search.distances();
  const auto jacobian = jacobian_of(fit.material, distances.count(), distances);
  const double misfit = 2.0 * fit.cost / std::max(distances.count() - int(jacobian.cols()), 1);
  set_uncertainty(fit, jacobian.transpose() * jacobian / std::max(misfit, 1.0),
                  seen_bounds_of(fit.material, seen.spectrum.extent));
  return fit;
}

}  // namespace hada
