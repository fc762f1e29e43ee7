#include "sheet/relaxed.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "mechanics/bar_network.h"
#include "mechanics/facet_springs.h"
#include "sheet/simulate.h"
#include "sheet/strain.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr int between_looks = 50;  // steps of the springs

std::vector<bool> pins_of(const Sheet& sheet, const std::vector<int>& pinned) {
  std::vector<bool> pins(sheet.flat.size(), false);
  for (const int v : pinned) {
    if (v < 0 || v >= sheet.vertices()) {
      throw Error("vertex " + std::to_string(v) + ": there is none; they run from 0 to " +
                  std::to_string(sheet.vertices() - 1));
    }
    pins[std::size_t(v)] = true;
  }
  return pins;
}

void move_by_springs(const Sheet& sheet, const StiffOptions& options, StiffSheet& result) {
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < sheet.faces(); ++f) faces.push_back(sheet.corners_of(f));
  std::vector<Vector3d> rest;
  for (const auto& p : sheet.flat) rest.emplace_back(p.x(), p.y(), 0.0);
  SpringMotion motion(facet_springs(faces, rest), sheet.folded, pins_of(sheet, options.pinned),
                      {.mass_by_springs = options.solver == StiffSolver::massed});
  while (result.steps < options.most_steps && motion.strain() > options.strain) {
    const int steps = std::min(between_looks, options.most_steps - result.steps);
    motion.step(steps);
    result.steps += steps;
  }
  result.places = motion.places();
  result.substeps = motion.substeps();
}

double largest(const std::vector<double>& of_faces) {
  return of_faces.empty() ? 0.0 : *std::max_element(of_faces.begin(), of_faces.end());
}

}  // namespace

StiffSheet stiffened(const Sheet& sheet, const StiffOptions& options) {
  StiffSheet result;
  if (options.solver == StiffSolver::exact) {
    BarNetwork network = rigid_network(sheet, 0.0);
    network.pinned = pins_of(sheet, options.pinned);
    Relaxed relaxed = relax(network, sheet.folded);
    result.places = std::move(relaxed.places);
    result.steps = relaxed.steps;
  } else {
    move_by_springs(sheet, options, result);
  }
  Sheet there = sheet;
  there.folded = result.places;
  result.strain = largest(face_strains(there));
  result.planarity = largest(face_planarities(there));
  return result;
}

}  // namespace hada
