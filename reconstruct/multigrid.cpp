#include "reconstruct/multigrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reconstruct/coarsen.h"
#include "reconstruct/dealt_arithmetic.h"
#include "reconstruct/extra_nodes.h"
#include "reconstruct/smooth.h"

namespace hada {
namespace {

constexpr std::size_t coarsest_nodes = 1000;  // factorised in a millisecond, solved in much less
// Edges of a coarse lattice differ a little near the border of any mask, and that is no reason to
// part its cells.
constexpr float least_strength = 0.1f;
// One sweep on the way down and one on the way up, each over-relaxed in the half that nothing else
// asks to be exact: about as good as one sweep more.
constexpr float over = 1.2f;
constexpr Relaxation before_restriction{over, 1.0f};
constexpr Relaxation after_correction{1.0f, over};
// The second and third levels are visited twice: what they leave would be half of all that a cycle
// leaves, and they are small. Not for the first height, which need not be as good; and not within
// conjugate gradients: where the lattices are coarsened badly, a second visit can undo more than it
// does.
constexpr std::size_t last_visited_twice = 2;
// Of cycles that visit every level once: the last one may, where that leaves little enough.
constexpr double single_rate = 0.3;
// What the coarser lattices find falls a little short nearly everywhere: of a square without holes
// a cycle leaves up to 0.033 of the error and never overshoots. With half of that taken off
// beforehand nothing is lost at either end; with a little more, since sweeps undo a part of it.
constexpr float lengthening = 1.025f;
constexpr double most_extras = 0.002;    // of all cells, up to which they go without a sweep
constexpr double least_rate = 0.1;       // of cycles, in the long run: the first ones do better
constexpr double worse = 3.0;            // than the last one the next may be, where those were good
constexpr double least_step_rate = 0.3;  // of steps of conjugate gradients
constexpr double slow = 0.4;             // rate of cycles above which conjugate gradients pay
// Where cycles are slow, what is left is seen less well.
constexpr double careful_tolerance = 1e-5;

System system_of(PixelLevel& level) {
  return {level, level.value.data(), level.right.data()};
}

void clear_extras(const PixelLevel& level, Cells& values) {
  std::fill(values.begin() + std::ptrdiff_t(level.at.size()), values.end(), 0.0f);
}

}  // namespace

Multigrid::Multigrid(PixelLevel finest) {
  const auto add = [this](PixelLevel level) {
    // The finest one is solved in the memory of the solution.
    if (!levels_.empty()) level.value = Cells(level.nodes(), level.memory());
    level.right = Cells(level.nodes(), level.memory());
    levels_.push_back(std::move(level));
    return CoarsestSolver::size_of(levels_.back());
  };
  std::size_t nodes = add(std::move(finest));
  cells_ = double(nodes);
  // Parts that hang together weakly are not joined, however small they are: stop when few were.
  for (std::size_t finer = 2 * nodes; nodes > coarsest_nodes && nodes < 0.8 * double(finer);) {
    finer = std::exchange(nodes, add(coarsened(levels_.back(), least_strength)));
  }
  coarsest_.emplace(levels_.back());
}

void Multigrid::run(std::size_t index, const std::vector<Stage>& stages) {
  run_wavefront(levels_[index].at.rows, levels_[index].at.size(), stages);
}

void Multigrid::go_down(std::size_t index, bool from_zero) {
  PixelLevel& level = levels_[index];
  PixelLevel& coarse = levels_[index + 1];
  if (from_zero) clear_extras(level, level.value);
  clear_extras(coarse, coarse.right);
  relax_extras(level, level.value, level.right, from_zero);
  {
    const PulledByExtras pulled(level, level.value, level.right);
    std::vector<Stage> stages;
    if (from_zero) {
      add_sweep_from_zero(system_of(level), before_restriction.red, stages);
    } else {
      add_sweep(system_of(level), before_restriction, stages);
    }
    add_restriction(system_of(level), coarse, stages);
    run(index, stages);
  }
  restrict_extras(level, level.value, level.right, coarse);
}

void Multigrid::go_up(std::size_t index) {
  PixelLevel& level = levels_[index];
  const PixelLevel& coarse = levels_[index + 1];
  correct_extras(level, coarse, level.value);
  {
    const PulledByExtras pulled(level, level.value, level.right);
    std::vector<Stage> stages;
    add_correction(system_of(level), coarse, 1.0f, stages);
    add_sweep(system_of(level), after_correction, stages);
    run(index, stages);
  }
  relax_extras(level, level.value, level.right, false);
}

// In one pass, where few extra nodes go without the sweeps in between.
void Multigrid::go_up_and_down(std::size_t index) {
  PixelLevel& level = levels_[index];
  PixelLevel& coarse = levels_[index + 1];
  if (double(level.extras.size()) > most_extras * double(level.at.size())) {
    go_up(index);
    return go_down(index, false);
  }
  correct_extras(level, coarse, level.value);
  clear_extras(coarse, coarse.right);
  {
    const PulledByExtras pulled(level, level.value, level.right);
    std::vector<Stage> stages;
    add_correction(system_of(level), coarse, 1.0f, stages);
    add_sweep(system_of(level), after_correction, stages);
    add_sweep(system_of(level), before_restriction, stages);
    add_restriction(system_of(level), coarse, stages);
    run(index, stages);
  }
  restrict_extras(level, level.value, level.right, coarse);
}

// What is left of a cycle after the way down from a level.
void Multigrid::come_back(std::size_t index) {
  const int visits = index > 0 && index <= visited_twice_ ? 2 : 1;
  for (int visit = 1; visit < visits; ++visit) {
    cycle(index + 1);
    go_up_and_down(index);
  }
  cycle(index + 1);
  go_up(index);
}

// From a value of 0.
void Multigrid::cycle(std::size_t index) {
  if (index + 1 == levels_.size()) return coarsest_->solve(levels_.back());
  go_down(index, true);
  come_back(index);
}

// Right-hand sides are added up, level by level, to the coarsest one; what is found there is
// carried up, with a cycle on every level but the finest. Down there a sweep on the way would cost
// as much as it saves above.
void Multigrid::find_first() {
  for (std::size_t index = 0; index + 1 < levels_.size(); ++index) {
    const PixelLevel& level = levels_[index];
    PixelLevel& coarse = levels_[index + 1];
    clear_extras(coarse, coarse.right);
    std::vector<Stage> stages;
    add_gathering(level, coarse, stages);
    run(index, stages);
    gather_extras(level, coarse);
  }
  coarsest_->solve(levels_.back());
  for (std::size_t index = levels_.size() - 2; index > 0; --index) {
    std::fill(levels_[index].value.begin(), levels_[index].value.end(), 0.0f);
    go_up_and_down(index);
    come_back(index);
  }
}

// Root mean square of what the second level has to correct.
double Multigrid::coarse_size() const {
  const PixelLevel& coarse = levels_[1];
  return std::sqrt(4.0 * dot(coarse.at, coarse.value, coarse.value) / cells_);
}

Multigrid::Solution Multigrid::solve(double tolerance, int max_cycles, const CycleDone& done) {
  PixelLevel& level = levels_.front();
  const Dealt& at = level.at;
  Solution solution;
  if (levels_.size() == 1) {
    level.value = Cells(level.nodes(), level.memory());
    coarsest_->solve(level);
    solution.value = Grid<float>(at.rows, at.cols, 0.0f, level.memory());
    add_times(level.at, 1.0, level.value, solution.value);
    return solution;
  }
  visited_twice_ = 0;
  find_first();
  solution.value = Grid<float>(at.rows + 2, int(at.stride()), 0.0f, level.memory());
  const System system{level, solution.value.data(), level.right.data(), magic_};
  double last = 0.0;
  double rate = 1.0;
  while (true) {
    std::vector<Stage> stages;
    const bool first = solution.cycles == 0;
    add_correction(system, levels_[1], first ? 1.0f : lengthening, stages);
    add_sweep(system, after_correction, stages);
    const bool slowly = solution.cycles > 1 && rate > slow;
    const bool end = (!first && solution.error < tolerance) || solution.cycles == max_cycles;
    if (end || slowly) {
      if (!end) add_subtraction(system, stages);
      run(0, stages);
      undeal(at, solution.value);
      if (!end) conjugate_steps(tolerance, max_cycles, done, solution);
      return solution;
    }
    add_sweep(system, before_restriction, stages);
    add_exact_restriction(system, levels_[1], stages);
    clear_extras(levels_[1], levels_[1].right);
    run(0, stages);
    const bool once = solution.cycles > 1 && solution.error * single_rate < tolerance;
    visited_twice_ = once ? 0 : last_visited_twice;
    cycle(1);
    ++solution.cycles;
    const double size = coarse_size();
    const double last_rate = solution.cycles > 2 ? rate : 0.0;  // nothing is known of the first
    rate = last > 0.0 ? size / last : 0.9;
    rate = std::min(std::max(rate, std::min(worse * rate, least_rate)), 0.9);
    last = size;
    // What is left does not shrink evenly.
    const double slower = std::max({rate, last_rate, once ? single_rate : 0.0});
    solution.error = size * slower / (1.0 - slower);  // what all further cycles would add
    if (done) done(solution.cycles, solution.error);
  }
}

// Flexible conjugate gradients: every cycle gives a direction, which is made independent of the
// last ones as far as the energy goes, and of which the best multiple is taken.
void Multigrid::conjugate_steps(double tolerance, int max_cycles, const CycleDone& done,
                                Solution& solution) {
  struct Direction {
    Cells step;
    Cells image;  // A step
    double energy = 0.0;
  };
  constexpr std::size_t remembered = 3;
  PixelLevel& level = levels_.front();
  visited_twice_ = 0;
  level.value = Cells(level.nodes(), level.memory());
  std::vector<Direction> directions;
  const double careful = std::min(tolerance, careful_tolerance);
  double last = 0.0;
  double last_rate = 0.9;
  while (solution.cycles < max_cycles) {
    const Cells residual = level.right;
    cycle(0);
    ++solution.cycles;
    std::vector<Stage> stages;
    add_subtraction(system_of(level), stages);
    run(0, stages);
    Direction direction{level.value, residual};
    add_times(level.at, -1.0, level.right, direction.image);
    for (const Direction& earlier : directions) {
      const double share = dot(level.at, direction.step, earlier.image) / earlier.energy;
      add_times(level.at, -share, earlier.step, direction.step);
      add_times(level.at, -share, earlier.image, direction.image);
    }
    direction.energy = dot(level.at, direction.step, direction.image);
    if (!(direction.energy > 0.0) || !std::isfinite(direction.energy)) return;
    const double length = dot(level.at, residual, direction.step) / direction.energy;
    level.right = residual;
    add_times(level.at, -length, direction.image, level.right);
    add_times(level.at, length, direction.step, solution.value);
    const double size =
        std::abs(length) * std::sqrt(dot(level.at, direction.step, direction.step) / cells_);
    const double rate = last > 0.0 ? std::clamp(size / last, least_step_rate, 0.9) : 0.9;
    const double slower = std::max(rate, last_rate);  // steps do not shrink evenly either
    solution.error = size * slower / (1.0 - slower);
    last = size;
    last_rate = rate;
    if (done) done(solution.cycles, solution.error);
    if (solution.error < careful) return;
    if (directions.size() == remembered) directions.erase(directions.begin());
    directions.push_back(std::move(direction));
  }
}

}  // namespace hada
