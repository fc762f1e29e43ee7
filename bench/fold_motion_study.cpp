#include "bench/fold_motion_study.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "core/quantile.h"
#include "core/random.h"
#include "io/fold_file.h"
#include "mechanics/facet_springs.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

using Eigen::Vector3d;
constexpr double degree = std::numbers::pi / 180.0;

// Zigzags of panels that are leaned by `sector` against the rows.
Sheet miura(int rows, int cols, double sector) {
  FoldFrame frame;
  const double lean = std::cos(sector), high = std::sin(sector);
  const auto vertex = [&](int i, int j) { return i * (cols + 1) + j; };
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= cols; ++j) {
      frame.vertices.emplace_back(j + (i % 2 == 0 ? 0.0 : lean), i * high, 0.0);
    }
  }
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= cols; ++j) {
      if (j < cols) {
        frame.edges.push_back({vertex(i, j), vertex(i, j + 1)});
        frame.assignment.push_back(i % 2 == 0 ? (j % 2 ? Crease::valley : Crease::mountain)
                                              : (j % 2 ? Crease::mountain : Crease::valley));
      }
      if (i < rows) {
        frame.edges.push_back({vertex(i, j), vertex(i + 1, j)});
        frame.assignment.push_back(j % 2 ? Crease::mountain : Crease::valley);
      }
      if (i < rows && j < cols) {
        frame.faces.push_back(
            {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
      }
    }
  }
  return sheet_of(frame, "miura");
}

// Processor time of this thread's work: others may use the machine.
double seconds_of(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<std::vector<int>> faces_of(const Sheet& sheet) {
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < sheet.faces(); ++f) faces.push_back(sheet.corners_of(f));
  return faces;
}

std::vector<Vector3d> shaken(std::vector<Vector3d> places, double by) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) places[i][axis] += by * gaussian(3, int(i), axis);
  }
  return places;
}

// The largest distance left after the best rotation (Kabsch 1976).
double misfit(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  Vector3d mean_a = Vector3d::Zero(), mean_b = mean_a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / double(a.size());
    mean_b += b[i] / double(a.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    spread += (b[i] - mean_b) * (a[i] - mean_a).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d flip = Eigen::Matrix3d::Identity();
  flip(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d turn = svd.matrixU() * flip * svd.matrixV().transpose();
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, (turn * (a[i] - mean_a) - (b[i] - mean_b)).norm());
  }
  return worst;
}

}  // namespace

std::vector<SpringSpeed> spring_speeds() {
  std::vector<SpringSpeed> speeds;
  for (const int side : {12, 20}) {
    const Sheet sheet = miura(side, side, 60.0 * degree);
    SpringMotion motion(facet_springs(faces_of(sheet), sheet.folded), shaken(sheet.folded, 0.01),
                        {}, {});
    std::vector<double> rates;
    for (int run = 0; run < 7; ++run) {
      constexpr int steps = 2000;
      const double seconds = seconds_of([&] { motion.step(steps); });
      rates.push_back(double(sheet.faces()) * steps * motion.substeps() / seconds);
    }
    speeds.push_back({"Miura " + std::to_string(side) + " x " + std::to_string(side), sheet.faces(),
                      median(rates), motion.substeps()});
  }
  return speeds;
}

std::vector<ExactScore> exact_scores() {
  std::vector<ExactScore> scores;
  for (const auto& [rows, cols] : {std::pair{10, 15}, {20, 20}}) {
    Sheet sheet = miura(rows, cols, 60.0 * degree);
    sheet.folded = simulate(sheet, {.share = 0.4}).places;
    const auto start = shaken(sheet.folded, 0.002);  // what a drag leaves behind
    const BarNetwork network = rigid_network(sheet, 0.0);
    ExactScore score;
    std::vector<double> times;
    for (int run = 0; run < 5; ++run) {
      Relaxed relaxed;
      times.push_back(1000.0 * seconds_of([&] { relaxed = relax(network, start); }));
      score = {sheet.faces(), relaxed.strain, relaxed.planarity, median(times)};
    }
    scores.push_back(score);
  }
  return scores;
}

double miura_error_deg() {
  double worst = 0.0;
  for (const double sector : {45.0 * degree, 60.0 * degree, 75.0 * degree}) {
    const Sheet sheet = miura(2, 2, sector);
    // The vertex in the middle: its creases along the row, and up and down.
    int along = -1, up = -1;
    for (int e = 0; e < sheet.edges(); ++e) {
      if (sheet.is_border(e)) continue;
      const auto way = sheet.flat[std::size_t(sheet.target(2 * e))] -
                       sheet.flat[std::size_t(sheet.origin(2 * e))];
      (std::abs(way.y()) < 1e-9 ? along : up) = e;
    }
    for (double fold = 10.0; fold < 175.0; fold += 20.0) {
      const double sign = sheet.fold_angles[std::size_t(along)] > 0.0 ? 1.0 : -1.0;
      SimulateOptions options;
      options.held = {{along, sign * fold * degree}};
      const auto shape = simulate(sheet, options);
      const double major = std::abs(shape.angles[std::size_t(along)]);
      const double minor = std::abs(shape.angles[std::size_t(up)]);
      const double one = 2.0 * std::atan(std::cos(sector) * std::tan(0.5 * major));
      const double other = 2.0 * std::atan(std::cos(sector) * std::tan(0.5 * minor));
      worst = std::max(worst, std::min(std::abs(one - minor), std::abs(other - major)) / degree);
      worst = std::max(worst, std::abs(major / degree - fold));
    }
  }
  return worst;
}

std::vector<DrivenScore> driven_scores(const std::filesystem::path& data) {
  std::vector<DrivenScore> scores;
  const auto folder = data / "fold" / "angles_3d";
  for (const auto& [name, file] : {std::pair{"diagonal", "diagonal/diagonal-cp"},
                                   {"simpleVertex", "simpleVertex/simpleVertex"}}) {
    const auto frame_at = [&, file = file](int percent) {
      return read_fold(folder / (std::string(file) + "_" + std::to_string(percent) + ".fold"))
          .frames[0];
    };
    FoldFrame flat = frame_at(0);
    const auto& face = flat.faces[0];
    const Vector3d a = flat.vertices[std::size_t(face[0])];
    const Vector3d normal =
        (flat.vertices[std::size_t(face[1])] - a).cross(flat.vertices[std::size_t(face[2])] - a);
    // It lies in its x-z plane; the printed side is where faces run counter-clockwise.
    const double side = normal.y() > 0.0 ? 1.0 : -1.0;
    const auto laid = [&](const Vector3d& p) {
      return Vector3d(p.x(), -side * p.z(), side * p.y());
    };
    for (Vector3d& p : flat.vertices) {
      p = laid(p);
      p.z() = 0.0;
    }
    const Sheet sheet = sheet_of(flat, name);
    double size = 0.0;
    for (const auto& p : sheet.flat) size = std::max(size, 2.0 * p.norm());
    for (const int percent : {-100, -75, -50, -25, 25, 50, 75, 100}) {
      FoldFrame truth = frame_at(percent);
      for (Vector3d& p : truth.vertices) p = laid(p);
      SimulateOptions options;
      options.share = percent / 100.0;
      options.rigid = false;
      scores.push_back(
          {name, percent, misfit(simulate(sheet, options).places, truth.vertices) / size});
    }
  }
  return scores;
}

}  // namespace hada
