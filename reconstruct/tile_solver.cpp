#include "reconstruct/tile_solver.h"

#include <algorithm>
#include <cstddef>

#include "reconstruct/least_squares.h"
#include "reconstruct/reweighted.h"
#include "reconstruct/sparse_bayesian.h"
#include "reconstruct/trimmed.h"

namespace hada {
namespace {

using Values = std::vector<float>;

// Calls `move(many, few)` on every array of samples or pixels that both tiles have, with the
// stride.
template <class From, class To, class Move>
void each_sample(From& from, To& to, const Move& move) {
  const auto lights = std::size_t(from.lights);
  move(from.grey, to.grey, lights);
  move(from.trust, to.trust, lights);
  move(from.weight, to.weight, lights);
  if (!from.raw.empty()) move(from.raw, to.raw, lights);
  if (!from.bounce.empty()) move(from.bounce, to.bounce, lights);
  if (from.near) {
    move(from.x_to, to.x_to, lights);
    move(from.y_to, to.y_to, lights);
    move(from.z_to, to.z_to, lights);
    move(from.closeness, to.closeness, lights);
  }
  move(from.x, to.x, 1);
  move(from.y, to.y, 1);
  move(from.z, to.z, 1);
}

void gather(const Tile& from, const std::vector<int>& places, Tile& to) {
  to.pixels = int(places.size());
  to.noise = from.noise;
  each_sample(from, to, [&](const Values& many, Values& few, std::size_t lights) {
    for (std::size_t k = 0; k < lights; ++k) {
      const float* source = &many[k * std::size_t(from.stride)];
      float* target = &few[k * std::size_t(to.stride)];
      for (std::size_t i = 0; i < places.size(); ++i) target[i] = source[places[i]];
    }
  });
}

void scatter(const Tile& from, const std::vector<int>& places, Tile& to) {
  const auto put = [&](const Values& few, Values& many, std::size_t lights) {
    for (std::size_t k = 0; k < lights; ++k) {
      const float* source = &few[k * std::size_t(from.stride)];
      float* target = &many[k * std::size_t(to.stride)];
      for (std::size_t i = 0; i < places.size(); ++i) target[places[i]] = source[i];
    }
  };
  put(from.weight, to.weight, std::size_t(from.lights));
  put(from.grey, to.grey, std::size_t(from.lights));
  put(from.x, to.x, 1);
  put(from.y, to.y, 1);
  put(from.z, to.z, 1);
}

void plain(Tile& tile, bool all_trusted, const NormalPlan& plan) {
  if (!all_trusted || tile.near) {
    tile.weighs_all = false;
    return fit_least_squares(tile);
  }
  fit_pseudo_inverse(tile, plan.pseudo_inverse);
  if (tile.weighs_all) return;
  std::fill(tile.weight.begin(), tile.weight.end(), 1.0f);
  tile.weighs_all = true;
}

}  // namespace

TileSolver::TileSolver(const NormalPlan& plan, const Tile& like) : plan_(plan), doubtful_(like) {}

void TileSolver::solve(Tile& tile, bool all_trusted) {
  tile.noise = plan_.noise;
  switch (plan_.estimator) {
    case Estimator::least_squares:
    case Estimator::lit_least_squares:
      plain(tile, all_trusted, plan_);
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

// Most pixels of most pictures are explained by least squares; only the others need more.
void TileSolver::solve_robust(Tile& tile, bool all_trusted) {
  const int rounds = plan_.shared ? shared_rounds : 0;
  plain(tile, all_trusted, plan_);
  for (int round = 0; round < rounds; ++round) {
    take_off(tile, plan_.terms);
    plain(tile, all_trusted, plan_);
  }
  screen(tile, flags_);
  places_.clear();
  for (int i = 0; i < tile.pixels; ++i) {
    if (flags_[std::size_t(i)]) places_.push_back(i);
  }
  if (places_.empty()) return;
  tile.weighs_all = false;
  if (plan_.shared) tile.grey = tile.raw;
  gather(tile, places_, doubtful_);
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
  if (plan_.shared) take_off(tile, plan_.terms);  // what `grey` held before
  scatter(doubtful_, places_, tile);
}

}  // namespace hada
