#include "fit/sequence_posterior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace hada {
namespace {

constexpr double same_class = 0.5;      // nats by which members of a class may be told apart
constexpr double worth_telling = 1e-6;  // probability of a sequence that is listed

struct Weighed {
  const SequenceCandidate* best;
  double probability;
};

/// Every sequence once, the likeliest first.
std::vector<Weighed> weighed(const std::vector<SequenceCandidate>& all, double scatter) {
  double least = HUGE_VAL;
  for (const auto& one : all) least = std::min(least, one.loss(scatter));
  std::map<std::string, Weighed> sequences;
  double total = 0.0;
  for (const auto& one : all) {
    const double weight = std::exp(least - one.loss(scatter));
    auto& known = sequences.try_emplace(one.model.sequence, Weighed{&one, 0.0}).first->second;
    if (one.loss(scatter) < known.best->loss(scatter)) known.best = &one;
    known.probability += weight;
    total += weight;
  }
  std::vector<Weighed> list;
  for (auto& [sequence, one] : sequences) list.push_back({one.best, one.probability / total});
  std::stable_sort(list.begin(), list.end(), [](const Weighed& a, const Weighed& b) {
    return a.probability > b.probability;
  });
  return list;
}

/// Nats by which a picture made with `a` is expected to speak against `b`.
double told_apart(const std::vector<double>& a, const std::vector<double>& b,
                  const GrainSpectrum& spectrum) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double d = std::log(a[k] / b[k]);
    sum += spectrum.count[k] * (std::exp(d) - 1.0 - d);
  }
  return sum;
}

struct Class {
  SequenceClass named;
  const SequenceCandidate* best;
  std::vector<double> cells;  // expected of the best
};

std::vector<Class> classes_of(const std::vector<Weighed>& list, const GrainSpectrum& spectrum) {
  std::vector<Class> classes;
  for (const Weighed& one : list) {
    if (one.probability < worth_telling) break;
    std::vector<double> cells;
    expected_cells(one.best->model, one.best->fit.nuisance, spectrum, cells);
    const auto found = std::find_if(classes.begin(), classes.end(), [&](const Class& other) {
      return told_apart(cells, other.cells, spectrum) < same_class;
    });
    if (found == classes.end()) {
      classes.push_back(
          {{{one.best->model.sequence}, one.probability}, one.best, std::move(cells)});
    } else {
      found->named.sequences.push_back(one.best->model.sequence);
      found->named.probability += one.probability;
    }
  }
  std::stable_sort(classes.begin(), classes.end(), [](const Class& a, const Class& b) {
    return a.named.probability > b.named.probability;
  });
  return classes;
}

}  // namespace

std::string_view kind_of(const std::string& sequence) {
  const auto columns = double(std::count(sequence.begin(), sequence.end(), 'C'));
  const double drawn = std::abs(2.0 * columns / double(sequence.size()) - 1.0);
  return drawn > 0.7 ? "masame" : drawn > 0.2 ? "itame" : "mokume";
}

SequencePosterior sequence_posterior(const std::vector<SequenceCandidate>& all,
                                     const GrainSpectrum& spectrum, double scatter) {
  const auto list = weighed(all, scatter);
  SequencePosterior posterior;
  for (const Weighed& one : list) {
    const auto kind = kind_of(one.best->model.sequence);
    (kind == "masame"  ? posterior.kinds.masame
     : kind == "itame" ? posterior.kinds.itame
                       : posterior.kinds.mokume) += one.probability;
  }
  auto classes = classes_of(list, spectrum);
  posterior.likeliest = *classes.front().best;
  for (auto& one : classes) posterior.classes.push_back(std::move(one.named));
  return posterior;
}

}  // namespace hada
