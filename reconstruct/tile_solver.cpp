#include "reconstruct/tile_solver.h"

#include <algorithm>
#include <cstddef>

#include "reconstruct/least_squares.h"
#include "reconstruct/reweighted.h"
#include "reconstruct/screen.h"
#include "reconstruct/sparse_bayesian.h"
#include "reconstruct/trimmed.h"

namespace hada {
namespace {

using Values = std::vector<float>;

void gather(const Values& many, const Tile& from, const std::vector<int>& places, Values& few,
            const Tile& to) {
  for (int k = 0; k < from.lights; ++k) {
    const float* source = &many[from.at(k, 0)];
    float* target = &few[to.at(k, 0)];
    for (const int place : places) *target++ = source[place];
  }
}

void scatter(const Values& few, const std::vector<int>& places, Values& many) {
  for (std::size_t i = 0; i < places.size(); ++i) many[std::size_t(places[i])] = few[i];
}

void scatter(const Values& few, const Tile& from, const std::vector<int>& places, Values& many,
             const Tile& to) {
  for (int k = 0; k < from.lights; ++k) {
    const float* source = &few[from.at(k, 0)];
    float* target = &many[to.at(k, 0)];
    for (const int place : places) target[place] = *source++;
  }
}

// Without a branch, which would be mispredicted at every doubtful pixel.
void find_places(const std::vector<std::uint8_t>& flags, int pixels, std::vector<int>& places) {
  places.resize(std::size_t(pixels));
  std::size_t count = 0;
  for (int i = 0; i < pixels; ++i) {
    places[count] = i;
    count += flags[std::size_t(i)];
  }
  places.resize(count);
}

}  // namespace

TileSolver::TileSolver(const NormalPlan& plan, const Tile& like, bool keep_weights)
    : plan_(plan), keep_weights_(keep_weights), doubtful_(like) {}

void TileSolver::solve(Tile& tile, bool all_trusted) {
  tile.noise = plan_.noise;
  switch (plan_.estimator) {
    case Estimator::least_squares:
    case Estimator::lit_least_squares:
      plain(tile, all_trusted);
      return;
    case Estimator::trimmed:
      return fit_trimmed(tile);
    case Estimator::huber:
      return fit_huber(tile);
    case Estimator::cauchy:
      return fit_cauchy(tile);
    case Estimator::l1:
      return fit_l1(tile);
    case Estimator::sparse_bayesian:
      return fit_sparse_bayesian(tile);
    case Estimator::robust_pca:
    case Estimator::biweight:
    case Estimator::adaptive:
      break;
  }
  solve_robust(tile, all_trusted);
}

// Most pixels of most pictures are explained by least squares, and most of the others by least
// squares without one sample; only what is left needs more.
void TileSolver::solve_robust(Tile& tile, bool all_trusted) {
  const int rounds = plan_.shared ? shared_rounds : 0;
  plain(tile, all_trusted);
  for (int round = 0; round < rounds; ++round) {
    take_off(tile, plan_.terms);
    plain(tile, all_trusted);
  }
  screen(tile, flags_);
  find_places(flags_, tile.pixels, places_);
  const bool one_by_one =
      all_trusted && !tile.near && !plan_.shared && tile.lights >= lights_for_dropping;
  if (one_by_one && !places_.empty()) {
    gather(tile, all_trusted);
    fit_pseudo_inverse(doubtful_, plan_.pseudo_inverse);
    drop_worst(doubtful_, plan_.pseudo_inverse, flags_);
    scatter_to(tile);
    find_places(flags_, doubtful_.pixels, still_);
    for (int& i : still_) i = places_[std::size_t(i)];
    places_.swap(still_);
  }
  if (places_.empty()) return;
  gather(tile, all_trusted);
  if (plan_.shared && plan_.terms.bounce != 0.0f) {
    SharedTerms bounce;
    bounce.bounce = plan_.terms.bounce;
    take_off(doubtful_, bounce);
  }
  fit_biweight(doubtful_);
  for (int round = 0; round < rounds; ++round) {
    take_off(doubtful_, plan_.terms);
    refit_biweight(doubtful_);
  }
  scatter_to(tile);
}

void TileSolver::plain(Tile& tile, bool all_trusted) {
  if (!all_trusted || tile.near) {
    tile.weighs_all = false;
    return fit_least_squares(tile);
  }
  fit_pseudo_inverse(tile, plan_.pseudo_inverse);
  if (tile.weighs_all || !keep_weights_) return;
  std::fill(tile.weight.begin(), tile.weight.end(), 1.0f);
  tile.weighs_all = true;
}

// The doubtful pixels, close together, before anything was taken off.
void TileSolver::gather(const Tile& tile, bool all_trusted) {
  doubtful_.pixels = int(places_.size());
  doubtful_.noise = tile.noise;
  const auto move = [&](const Values& many, Values& few) {
    hada::gather(many, tile, places_, few, doubtful_);
  };
  move(plan_.shared ? tile.raw : tile.grey, doubtful_.grey);
  if (!tile.raw.empty()) move(tile.raw, doubtful_.raw);
  if (!tile.bounce.empty()) move(tile.bounce, doubtful_.bounce);
  if (tile.near) {
    move(tile.x_to, doubtful_.x_to);
    move(tile.y_to, doubtful_.y_to);
    move(tile.z_to, doubtful_.z_to);
    move(tile.closeness, doubtful_.closeness);
  }
  if (!all_trusted) {
    move(tile.trust, doubtful_.trust);
  } else if (!doubtful_.trusts_all) {
    std::fill(doubtful_.trust.begin(), doubtful_.trust.end(), 1.0f);
  }
  doubtful_.trusts_all = all_trusted;
}

void TileSolver::scatter_to(Tile& tile) const {
  scatter(doubtful_.x, places_, tile.x);
  scatter(doubtful_.y, places_, tile.y);
  scatter(doubtful_.z, places_, tile.z);
  if (!keep_weights_) return;
  tile.weighs_all = false;
  scatter(doubtful_.weight, doubtful_, places_, tile.weight, tile);
  if (plan_.shared) scatter(doubtful_.grey, doubtful_, places_, tile.grey, tile);
}

}  // namespace hada
