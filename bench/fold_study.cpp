#include "bench/fold_study.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <map>
#include <sstream>

#include <Eigen/SVD>

#include "core/quantile.h"
#include "io/fold_file.h"
#include "sheet/arrangement.h"
#include "sheet/flat_check.h"
#include "sheet/flat_fold.h"
#include "sheet/layers.h"

namespace hada {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<Eigen::Vector2d>;

// The largest distance left after the best rotation or reflection (Kabsch 1976).
double misfit(const Points& a, const Points& b) {
  Eigen::Vector2d mean_a = Eigen::Vector2d::Zero(), mean_b = mean_a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / double(a.size());
    mean_b += b[i] / double(a.size());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    spread += (b[i] - mean_b) * (a[i] - mean_a).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix2d turn = svd.matrixU() * svd.matrixV().transpose();
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, (turn * (a[i] - mean_a) - (b[i] - mean_b)).norm());
  }
  return worst;
}

// States by the three digits that begin a file's name. Commas inside | | or quotes do not occur.
std::map<std::string, std::string> published_states(const fs::path& path) {
  std::map<std::string, std::string> states;
  std::ifstream stream(path);
  std::string line, cell;
  std::getline(stream, line);
  constexpr int column = 15;
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    std::string number;
    std::getline(cells, number, ',');
    for (int i = 0; i < column; ++i) std::getline(cells, cell, ',');
    states[number] = cell;
  }
  return states;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<PatternScore> score_patterns(const fs::path& data, int runs) {
  const auto published = published_states(data / "fold" / "states.csv");
  std::vector<PatternScore> scores;
  for (const fs::path& path : files_in(data / "fold" / "crease_patterns")) {
    PatternScore score;
    score.name = path.stem().string();
    const auto known = published.find(score.name.substr(0, 3));
    if (known != published.end()) score.states_published = known->second;
    const Sheet sheet = sheet_of(read_fold(path).frames[0], path.string());
    score.faces = sheet.faces();
    FlatState state;
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
      const std::clock_t start = std::clock();  // of the processor: others may use the machine
      state = flat_state(sheet);
      score.states = layer_orders(sheet, state).states();
      times.push_back(1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    score.milliseconds = median(times);
    const FoldFile folded =
        read_fold(data / "fold" / "folded_states" / (score.name + ".folded.fold"));
    Points truth;
    for (const auto& p : folded.frames[0].vertices) truth.push_back(p.head<2>());
    score.geometry_error = misfit(state.vertices, truth) / size_of(sheet.flat);
    scores.push_back(score);
  }
  return scores;
}

std::vector<Rejection> score_unfoldable(const fs::path& data) {
  std::vector<Rejection> rejections;
  for (const fs::path& path : files_in(data / "fold" / "unfoldable")) {
    const Sheet sheet = sheet_of(read_fold(path).frames[0], path.string());
    const auto flaws = flat_flaws(sheet);
    rejections.push_back({path.stem().string(), flaws.empty()
                                                    ? layer_orders(sheet, flat_state(sheet)).reason
                                                    : flaws[0].reason});
  }
  return rejections;
}

}  // namespace hada
