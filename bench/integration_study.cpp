#include "bench/integration_study.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numbers>
#include <numeric>
#include <thread>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "bench/integration_peers.h"
#include "core/parallel.h"
#include "core/random.h"
#include "io/disk_memory.h"
#include "reconstruct/integrate.h"

namespace hada {
namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double status_megabytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0.0;
    if (word == name && status >> kilobytes) return kilobytes / 1024.0;
  }
  return 0.0;
}

// Watches the memory that belongs to no file, twenty times a second.
class MostAnonymous {
 public:
  MostAnonymous()
      : watch_([this] {
          while (!end_) {
            most_ = std::max(most_, status_megabytes("RssAnon:"));
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
          }
        }) {}
  ~MostAnonymous() { stop(); }
  double megabytes() {
    stop();
    return most_;
  }

 private:
  void stop() {
    end_ = true;
    if (watch_.joinable()) watch_.join();
  }
  double most_ = 0.0;
  std::atomic<bool> end_ = false;
  std::thread watch_;
};

// The most resident memory so far since `forget_peak`, in MB.
double peak_megabytes() {
  return status_megabytes("VmHWM:");
}

void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

bool is_open(MaskKind kind, int row, int col, int size) {
  if (kind == MaskKind::full) return true;
  if (kind == MaskKind::slits) {
    const int step = size / 16;
    const int wall = col / step;
    if (wall == 0 || col % step > 1) return true;
    return wall % 2 == 1 ? row < size / 8 : row >= size - size / 8;
  }
  const double x = (col + 0.5) / size - 0.5;
  const double y = (row + 0.5) / size - 0.5;
  const double angle = std::atan2(y, x);
  const double radius =
      0.526 + 0.034 * std::sin(7.0 * angle) + 0.022 * std::sin(23.0 * angle + 1.0);
  if (std::hypot(x, y) > radius || uniform(1, row, col) < 0.0025) return false;
  return true;
}

void cut_holes(Mask& mask) {
  const int size = mask.rows();
  for (int hole = 0; hole < 60; ++hole) {
    const double y = uniform(2, hole, 0) * size;
    const double x = uniform(2, hole, 1) * size;
    const double radius = 0.03 * uniform(2, hole, 2) * size;
    for (int row = std::max(0, int(y - radius)); row < std::min<double>(size, y + radius); ++row) {
      for (int col = std::max(0, int(x - radius)); col < std::min<double>(size, x + radius);
           ++col) {
        if (std::hypot(row - y, col - x) < radius) mask(row, col) = 0;
      }
    }
  }
}

double height_at(double row, double col, int size) {
  const double x = col / size - 0.5;
  const double y = row / size - 0.5;
  return size * (0.10 * x * x - 0.15 * x * y + 0.07 * y * y + 0.02 * std::sin(9.0 * x + 5.0 * y) +
                 0.004 * std::sin(60.0 * x - 35.0 * y)) +
         2.0 * std::sin(0.21 * col + 0.13 * row) + 0.3 * std::sin(0.9 * col - 0.5 * row);
}

}  // namespace

IntegrationScene integration_scene(MaskKind kind, int size, std::pmr::memory_resource* where) {
  IntegrationScene scene{Mask(size, size, 0, where),
                         SlopeMap(size, size, Eigen::Vector2f::Zero(), where),
                         Grid<double>(size, size, 0.0, where)};
  for_each_index(size, [&](int row) {
    double slope = height_at(row, 0.5, size) - height_at(row, -0.5, size);
    for (int col = 0; col < size; ++col) {
      scene.mask(row, col) = is_open(kind, row, col, size);
      scene.height(row, col) = height_at(row, col, size);
      scene.slopes(row, col).x() = float(slope);
      slope = 2.0 * (height_at(row, col + 1, size) - scene.height(row, col)) - slope;
    }
  });
  std::vector<double> slope(std::size_t(size), 0.0);
  for_slices(size, [&](int begin, int end) {
    for (int col = begin; col < end; ++col) {
      slope[std::size_t(col)] = height_at(-0.5, col, size) - height_at(0.5, col, size);
    }
    for (int row = 0; row < size; ++row) {
      for (int col = begin; col < end; ++col) {
        double& here = slope[std::size_t(col)];
        scene.slopes(row, col).y() = float(here);
        const double below = row + 1 < size ? scene.height(row + 1, col) : 0.0;
        here = 2.0 * (scene.height(row, col) - below) - here;
      }
    }
  });
  if (kind == MaskKind::irregular) cut_holes(scene.mask);
  return scene;
}

double error_px(const IntegrationScene& scene, const Grid<float>& height) {
  const Regions regions = regions_of(scene.mask);
  std::vector<double> mean(regions.size.size(), 0.0);
  const auto for_pixels = [&](const auto& work) {
    for (int row = 0; row < height.rows(); ++row) {
      for (const auto& run : regions.row(row)) {
        for (int col = run.first; col < run.last; ++col) {
          work(std::size_t(run.region), double(height(row, col)) - scene.height(row, col));
        }
      }
    }
  };
  for_pixels([&](std::size_t region, double e) { mean[region] += e / regions.size[region]; });
  double sum = 0.0;
  for_pixels([&](std::size_t region, double e) { sum += std::pow(e - mean[region], 2); });
  return std::sqrt(sum / (double(scene.mask.size()) - regions.size[0]));
}

IntegrationProblem problem_of(const IntegrationScene& scene) {
  IntegrationProblem problem;
  const int rows = scene.mask.rows();
  const int cols = scene.mask.cols();
  problem.unknown = Grid<int>(rows, cols, -1);
  for (std::size_t i = 0; i < scene.mask.size(); ++i) {
    if (scene.mask[i]) problem.unknown[i] = problem.unknowns++;
  }
  problem.right.assign(std::size_t(problem.unknowns), 0.0);
  const EdgeRises rises = rises_of(scene.slopes, scene.mask);
  const auto add = [&](int a, int b, double rise) {
    problem.edges.push_back({a, b});
    problem.right[std::size_t(a)] -= rise;
    problem.right[std::size_t(b)] += rise;
  };
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const int here = problem.unknown(row, col);
      if (here < 0) continue;
      const int right = col + 1 < cols ? problem.unknown(row, col + 1) : -1;
      const int below = row + 1 < rows ? problem.unknown(row + 1, col) : -1;
      if (right >= 0) add(here, right, rises.east(row, col));
      if (below >= 0) add(here, below, rises.south(row, col));
    }
  }
  // One pixel of every region is tied to 0, for the solvers that want a regular matrix.
  const Regions regions = regions_of(scene.mask);
  std::vector<char> tied(regions.size.size(), 0);
  for (int row = 0; row < rows; ++row) {
    for (const auto& run : regions.row(row)) {
      if (std::exchange(tied[std::size_t(run.region)], 1) == 0) {
        problem.tied.push_back(problem.unknown(row, run.first));
      }
    }
  }
  return problem;
}

SolverRun timed(const std::string& solver, const IntegrationScene& scene,
                const std::function<std::vector<double>(const IntegrationProblem&)>& solve,
                const std::function<std::vector<double>()>& collect) {
  const IntegrationProblem problem = problem_of(scene);
  const double begin = processor_seconds();
  std::vector<double> height = solve(problem);
  const double seconds = processor_seconds() - begin;
  if (collect) height = collect();
  Grid<float> result(scene.mask.rows(), scene.mask.cols());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (scene.mask[i]) result[i] = float(height[std::size_t(problem.unknown[i])]);
  }
  return {solver, scene.mask.rows(), seconds, error_px(scene, result)};
}

SolverRun run_ours(const IntegrationScene& scene, int repeats, int threads) {
  const IntegrateOptions options;
  std::vector<double> seconds;
  SolverRun run{threads == 1 ? "hada" : "hada, " + std::to_string(threads) + " threads",
                scene.mask.rows()};
  const auto now = [&] { return threads == 1 ? processor_seconds() : wall_seconds(); };
  set_threads(threads);
  for (int i = 0; i < repeats; ++i) {
    forget_peak();
    const double before = peak_megabytes();
    const double begin = now();
    SlopeSolver solver(scene.mask);
    const Grid<float> height =
        solver.height(scene.slopes, options.tolerance_px, options.max_cycles);
    seconds.push_back(now() - begin);
    run.megabytes = std::max(run.megabytes, peak_megabytes() - before);
    run.cycles = solver.cycles();
    if (i == 0) run.error_px = error_px(scene, height);
  }
  set_threads(0);
  std::sort(seconds.begin(), seconds.end());
  run.seconds = seconds[seconds.size() / 2];
  return run;
}

SolverRun run_on_disk(MaskKind kind, int size, const std::filesystem::path& folder) {
  DiskMemory disk(folder);
  const IntegrationScene scene = integration_scene(kind, size, &disk);
  SolverRun run{"hada, on the disk", size};
  MostAnonymous most;
  const double begin = wall_seconds();
  SlopeSolver solver(scene.mask);
  const IntegrateOptions options;
  const Grid<float> height = solver.height(scene.slopes, options.tolerance_px, options.max_cycles);
  run.seconds = wall_seconds() - begin;
  run.megabytes = most.megabytes();
  run.cycles = solver.cycles();
  run.error_px = error_px(scene, height);
  return run;
}

SolverRun run_eigen_cg(const IntegrationScene& scene) {
  return timed("Eigen, conjugate gradients", scene, [](const IntegrationProblem& problem) {
    const auto matrix = matrix_of(problem, false);
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(
        matrix);
    solver.setTolerance(1e-8);
    const Eigen::VectorXd height = solver.solve(Eigen::Map<const Eigen::VectorXd>(
        problem.right.data(), Eigen::Index(problem.right.size())));
    return std::vector<double>(height.begin(), height.end());
  });
}

Eigen::SparseMatrix<double> matrix_of(const IntegrationProblem& problem, bool tied) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b] : problem.edges) {
    entries.emplace_back(a, a, 1.0);
    entries.emplace_back(b, b, 1.0);
    entries.emplace_back(a, b, -1.0);
    entries.emplace_back(b, a, -1.0);
  }
  for (const int node : problem.tied) {
    if (tied) entries.emplace_back(node, node, 1.0);
  }
  Eigen::SparseMatrix<double> matrix(problem.unknowns, problem.unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double one_pass_seconds(int size) {
  const std::vector<float> array(std::size_t(size) * std::size_t(size), 1.0f);
  double best = 1e9;
  volatile float keep = 0.0f;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const double begin = processor_seconds();
    float lanes[64] = {};
    for (std::size_t i = 0; i + 64 <= array.size(); i += 64) {
      for (std::size_t lane = 0; lane < 64; ++lane) lanes[lane] += array[i + lane];
    }
    keep = std::accumulate(lanes, lanes + 64, 0.0f);
    best = std::min(best, processor_seconds() - begin);
  }
  (void)keep;
  return best;
}

}  // namespace hada
