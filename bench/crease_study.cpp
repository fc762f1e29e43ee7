#include "bench/crease_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "capture/photograph.h"
#include "core/random.h"
#include "measure/creases.h"
#include "reconstruct/reconstruct.h"
#include "sheet/simulate.h"
#include "synth/folded.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double degree = std::numbers::pi / 180.0;

struct Truth {
  FoldFrame frame;  // in space, centred
  double folds_deg[2];
};

// A sheet of 80 x 60 mm with two creases from edge to edge that do not meet.
Truth made_sheet(Seed seed, const CreaseStudyOptions& options) {
  FoldFrame frame;
  const auto line = [&](double x1, double y1, double x2, double y2, Crease crease) {
    const int first = int(frame.vertices.size());
    frame.vertices.emplace_back(x1, y1, 0.0);
    frame.vertices.emplace_back(x2, y2, 0.0);
    frame.edges.push_back({first, first + 1});
    frame.assignment.push_back(crease);
  };
  line(-40, -30, 40, -30, Crease::border);
  line(40, -30, 40, 30, Crease::border);
  line(40, 30, -40, 30, Crease::border);
  line(-40, 30, -40, -30, Crease::border);
  Truth truth{};
  for (int k = 0; k < 2; ++k) {
    const double middle = k == 0 ? -14.0 : 14.0;
    line(middle + 8.0 * (uniform(seed, k, 1) - 0.5), -30,
         middle + 8.0 * (uniform(seed, k, 2) - 0.5), 30, Crease::valley);
  }
  Sheet sheet = sheet_of(frame, "sheet");
  int k = 0;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    const double share = uniform(seed, k, 3);
    const double fold =
        options.fold_low_deg * std::pow(options.fold_high_deg / options.fold_low_deg, share);
    truth.folds_deg[k] = uniform(seed, k, 4) < 0.5 ? fold : -fold;
    sheet.fold_angles[std::size_t(e)] = truth.folds_deg[k++] * degree;
  }
  sheet.folded = simulate(sheet).places;
  // The panel in the middle lies level, so that no lamp sets behind another.
  int middle_face = 0;
  for (int f = 0; f < sheet.faces(); ++f) {
    int creases = 0;
    for (const int h : sheet.halves_of(f)) creases += sheet.is_border(h / 2) ? 0 : 1;
    if (creases == 2) middle_face = f;
  }
  const auto corners = sheet.corners_of(middle_face);
  const Vector3d a = sheet.folded[std::size_t(corners[0])];
  const Vector3d normal = (sheet.folded[std::size_t(corners[1])] - a)
                              .cross(sheet.folded[std::size_t(corners[2])] - a)
                              .normalized();
  const Eigen::Quaterniond level = Eigen::Quaterniond::FromTwoVectors(normal, Vector3d::UnitZ());
  Vector3d mean = Vector3d::Zero();
  for (Vector3d& p : sheet.folded) {
    p = level * p;
    mean += p / double(sheet.folded.size());
  }
  for (Vector3d& p : sheet.folded) p -= mean;
  truth.frame = folded_frame(sheet);
  truth.frame.fold_angle_deg.clear();
  for (const double angle : sheet.fold_angles) truth.frame.fold_angle_deg.push_back(angle / degree);
  return truth;
}

void roughen(Surface& surface, double deg, Seed seed) {
  // As coarse as the picture's pixels: finer roughness would dim the paper and flatten its slopes.
  const double sigma = std::tan(deg * degree);
  for (int row = 0; row < surface.extent.rows; ++row) {
    for (int col = 0; col < surface.extent.cols; ++col) {
      auto& n = surface.normals(row, col);
      n = (n / n.z() + Eigen::Vector3f(float(sigma * gaussian(seed, row / 2, col / 2, 0)),
                                       float(sigma * gaussian(seed, row / 2, col / 2, 1)), 0.0f))
              .normalized();
    }
  }
}

Rig rig_of(const CreaseStudyOptions& options, Seed seed) {
  Rig rig;
  rig.rows = 360;
  rig.cols = 460;
  rig.pitch_mm = 0.2;
  rig.seed = seed;
  rig.cast_shadows = false;
  for (int k = 0; k < options.lights; ++k) {
    const double azimuth =
        2.0 * std::numbers::pi * (k + 0.3 * uniform(seed, k, 7)) / options.lights;
    const double slant = (k % 2 ? 30.0 : 45.0) * degree;
    Light light;
    light.image = "light_" + std::to_string(k);
    light.direction = Vector3d(std::sin(slant) * std::cos(azimuth),
                               std::sin(slant) * std::sin(azimuth), std::cos(slant));
    rig.lights.push_back(light);
  }
  return rig;
}

}  // namespace

CreaseStudy study_creases(const CreaseStudyOptions& options) {
  CreaseStudy study;
  double squares = 0.0, line_squares = 0.0;
  int covered = 0, lines = 0;
  for (Seed seed = 1; seed <= Seed(options.sheets); ++seed) {
    const Truth truth = made_sheet(seed, options);
    Surface sheet = folded_surface(truth.frame, {640, 840, 0.1, Unit::mm});
    roughen(sheet, options.roughness_deg, seed);
    LightStack stack = photograph(sheet, rig_of(options, seed));
    for (std::size_t k = 0; k < stack.lights.size(); ++k) {
      // Wrong by so much in a direction of its own.
      const Vector3d about =
          Vector3d(gaussian(seed, int(k), 8), gaussian(seed, int(k), 9), 0.0).normalized();
      stack.lights[k].direction =
          Eigen::AngleAxisd(options.light_error_deg * degree, about) * stack.lights[k].direction;
      // What a sphere says of its reading; a tenth of a degree where it is right.
      stack.lights[k].direction_sigma = std::max(options.light_error_deg, 0.1) * degree;
    }
    const Surface seen = reconstruct(stack, {.estimator = Estimator::least_squares}).surface;
    const MeasuredCreases found =
        measured_creases(seen, {}, options.from_pictures ? &stack : nullptr);
    // The frame of what was found lies about the middle of the cropped sheet.
    const Vector2d shift =
        Extent{360, 460, 0.2, Unit::mm}.place(seen.offset_px.y() + 0.5 * seen.extent.rows - 0.5,
                                              seen.offset_px.x() + 0.5 * seen.extent.cols - 0.5);
    for (std::size_t e = 0; e < truth.frame.edges.size(); ++e) {
      if (truth.frame.assignment[e] == Crease::border) continue;
      ++study.creases;
      const Vector2d a = truth.frame.vertices[std::size_t(truth.frame.edges[e][0])].head<2>();
      const Vector2d b = truth.frame.vertices[std::size_t(truth.frame.edges[e][1])].head<2>();
      const Vector2d way = (b - a).normalized(), across(-way.y(), way.x());
      for (const MeasuredCrease& crease : found.creases) {
        const double off_from = across.dot(crease.from + shift - a);
        const double off_to = across.dot(crease.to + shift - a);
        if (std::abs(off_from) > 3.0 || std::abs(off_to) > 3.0) continue;
        ++study.found;
        const double error = crease.fold_angle / degree - truth.frame.fold_angle_deg[e];
        squares += error * error;
        study.worst_deg = std::max(study.worst_deg, std::abs(error));
        covered += std::abs(error) <= 1.645 * crease.fold_angle_sigma / degree;
        line_squares += (off_from * off_from + off_to * off_to) / 0.04;
        lines += 2;
        break;
      }
    }
  }
  if (study.found > 0) {
    study.rms_deg = std::sqrt(squares / study.found);
    study.coverage90 = double(covered) / study.found;
    study.line_rms_px = std::sqrt(line_squares / lines);
  }
  return study;
}

}  // namespace hada
