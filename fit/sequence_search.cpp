#include "fit/sequence_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr std::size_t beam = 8;     // sequences whose neighbours are looked at
constexpr std::size_t guessed = 6;  // guesses whose nuisance is fitted
constexpr int most_rounds = 8;
constexpr std::size_t kept = 300;  // sequences that are still looked at after a round
constexpr int iterations = 20;
constexpr std::array other_scales{0.87, 1.15};  // where the search begins besides 1

bool likelier(const SequenceCandidate& a, const SequenceCandidate& b) {
  const double x = a.loss(), y = b.loss();
  return x < y || (x == y && a.model.sequence < b.model.sequence);
}

/// The cuts of both kinds as evenly mixed as possible.
std::string mixed(int columns, int rows) {
  std::string sequence;
  const int folds = columns + rows;
  for (int k = 0, made = 0; k < folds; ++k) {
    const bool column = (k + 1) * columns / folds > made;
    made += column;
    sequence += column ? 'C' : 'R';
  }
  return sequence;
}

/// All that differ from `sequence` by one letter or one exchange of neighbours.
std::vector<std::string> neighbours(const std::string& sequence, int fewest, int most) {
  std::vector<std::string> all;
  const std::size_t n = sequence.size();
  for (std::size_t k = 0; k < n; ++k) {
    all.push_back(sequence);
    all.back()[k] = sequence[k] == 'C' ? 'R' : 'C';
    if (int(n) > fewest) all.push_back(sequence.substr(0, k) + sequence.substr(k + 1));
    for (std::size_t other = k + 1; other < n; ++other) {
      if (sequence[k] == sequence[other]) continue;
      all.push_back(sequence);
      std::swap(all.back()[k], all.back()[other]);
    }
  }
  for (std::size_t k = 0; int(n) < most && k <= n; ++k) {
    for (const char cut : {'C', 'R'}) {
      all.push_back(sequence);
      all.back().insert(k, 1, cut);
    }
  }
  return all;
}

class Beam {
 public:
  Beam(std::vector<SequenceCandidate> pool, const GrainSpectrum& spectrum,
       const SequenceSearchOptions& options)
      : pool_(std::move(pool)), spectrum_(spectrum), options_(options) {
    std::sort(pool_.begin(), pool_.end(), likelier);
    std::erase_if(pool_,
                  [&](const auto& one) { return !known_.insert(one.model.sequence).second; });
    settle();
  }

  std::vector<SequenceCandidate> run() {
    for (int round = 0; round < most_rounds && grow(); ++round) settle();
    for (int round = 0; round < 3 && refine(std::size_t(options_.refined)); ++round) settle();
    return std::move(pool_);
  }

 private:
  /// Looks at the neighbours of the likeliest; whether there were any new ones.
  bool grow() {
    std::vector<std::string> fresh;
    for (std::size_t k = 0; k < std::min(beam, pool_.size()); ++k) {
      const std::string& sequence = pool_[k].model.sequence;
      if (!expanded_.insert(sequence).second) continue;
      for (auto& next : neighbours(sequence, options_.fewest_folds, options_.most_folds)) {
        if (known_.insert(next).second) fresh.push_back(std::move(next));
      }
    }
    const std::size_t old = pool_.size();
    pool_.resize(old + fresh.size());
    for_each_index(int(fresh.size()), [&](int k) {
      pool_[old + std::size_t(k)].model = grain_model(fresh[std::size_t(k)], options_.kernel,
                                                      spectrum_, nuisance_.scale, nuisance_.aspect);
    });
    if (!fresh.empty()) {
      judge();
      refine(2);
    }
    return !fresh.empty();
  }

  /// Fits the nuisance of the likeliest `count` that have not been; whether there were any.
  bool refine(std::size_t count) {
    std::vector<SequenceCandidate*> chosen;
    for (std::size_t k = 0; k < std::min(count, pool_.size()); ++k) {
      if (refined_.insert(pool_[k].model.sequence).second) chosen.push_back(&pool_[k]);
    }
    for_each_index(int(chosen.size()), [&](int k) {
      auto& one = *chosen[std::size_t(k)];
      one.fit = fit_nuisance(one.model, spectrum_, one.fit.nuisance, iterations, options_.scale);
    });
    return !chosen.empty();
  }

  /// The nuisance of the likeliest is that of the picture, until a sequence has its own.
  void settle() {
    std::sort(pool_.begin(), pool_.end(), likelier);
    if (pool_.size() > kept) pool_.resize(kept);
    nuisance_ = pool_.front().fit.nuisance;
    nuisance_of_ = pool_.front().model;
    occam_ = pool_.front().fit.occam;
    judge();
  }

  void judge() {
    for_each_index(int(pool_.size()), [&](int k) {
      auto& one = pool_[std::size_t(k)];
      if (refined_.contains(one.model.sequence)) return;
      rescale(one.model, spectrum_, nuisance_.scale, nuisance_.aspect);
      const auto nuisance = carried_over(nuisance_, nuisance_of_, one.model);
      one.fit = {nuisance, grain_cost(one.model, nuisance, spectrum_), occam_};
    });
    std::sort(pool_.begin(), pool_.end(), likelier);
  }

  std::vector<SequenceCandidate> pool_;
  const GrainSpectrum& spectrum_;
  SequenceSearchOptions options_;
  GrainNuisance nuisance_;
  GrainModel nuisance_of_;  // the sequence whose it is
  double occam_ = 0.0;
  std::set<std::string> known_, expanded_, refined_;
};

}  // namespace

double SequenceCandidate::loss(double scatter) const {
  return fit.cost / scatter + fit.occam + std::log(2.0) * double(model.sequence.size());
}

std::vector<SequenceCandidate> first_guesses(const GrainSpectrum& spectrum,
                                             const SequenceSearchOptions& options) {
  std::set<std::string> sequences;
  for (int folds = options.fewest_folds; folds <= options.most_folds; ++folds) {
    for (int columns = 0; columns <= folds; ++columns) {
      const auto c = std::string(std::size_t(columns), 'C');
      const auto r = std::string(std::size_t(folds - columns), 'R');
      sequences.insert({c + r, r + c, mixed(columns, folds - columns)});
    }
  }
  const std::vector<std::string> all(sequences.begin(), sequences.end());
  std::vector<SequenceCandidate> guesses(all.size());
  // Grain with the noise and the levels of a photograph, or without them: from one of the two the
  // descent finds its way.
  const GrainNuisance photographed{}, clean{1.0, 0.05, 2e-4, 0.02};
  for_each_index(int(all.size()), [&](int k) {
    auto& one = guesses[std::size_t(k)];
    one.model = grain_model(all[std::size_t(k)], options.kernel, spectrum);
    one.fit = {photographed, grain_cost(one.model, photographed, spectrum)};
    if (options.scale == GrainScale::one) return;
    for (const double scale : other_scales) {
      GrainNuisance scaled = photographed;
      scaled.scale = scale;
      rescale(one.model, spectrum, scale, 1.0);
      const double cost = grain_cost(one.model, scaled, spectrum);
      if (cost < one.fit.cost) one.fit = {scaled, cost};
    }
  });
  std::sort(guesses.begin(), guesses.end(), likelier);
  for_each_index(int(std::min(guessed, guesses.size())), [&](int k) {
    auto& one = guesses[std::size_t(k)];
    GrainNuisance other_start = clean;
    other_start.scale = one.fit.nuisance.scale;
    GrainModel other_model = one.model;
    const auto other = fit_nuisance(other_model, spectrum, other_start, iterations, options.scale);
    one.fit = fit_nuisance(one.model, spectrum, one.fit.nuisance, iterations, options.scale);
    if (other.cost + other.occam < one.fit.cost + one.fit.occam) {
      one.fit = other;
      one.model = std::move(other_model);
    }
  });
  std::sort(guesses.begin(), guesses.end(), likelier);
  return guesses;
}

std::vector<SequenceCandidate> refitted(std::vector<SequenceCandidate> candidates, std::size_t most,
                                        const GrainSpectrum& spectrum,
                                        const SequenceSearchOptions& options) {
  candidates.resize(std::min(most, candidates.size()));
  for_each_index(int(candidates.size()), [&](int k) {
    auto& one = candidates[std::size_t(k)];
    one.fit = fit_nuisance(one.model, spectrum, one.fit.nuisance, iterations, options.scale);
  });
  return candidates;
}

std::vector<SequenceCandidate> likely_sequences(std::vector<SequenceCandidate> guesses,
                                                const GrainSpectrum& spectrum,
                                                const SequenceSearchOptions& options) {
  return Beam(std::move(guesses), spectrum, options).run();
}

}  // namespace hada
