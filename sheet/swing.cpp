#include "sheet/swing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "mechanics/bar_network.h"
#include "sheet/arrangement.h"
#include "sheet/flaps.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

using Eigen::Vector3d;
using Faces = std::vector<bool>;

constexpr double pi = std::numbers::pi;
constexpr double largest_stage = pi / 36.0;  // in which what is linked follows

struct Axis {
  Vector3d from, along;  // along has unit length, the face to its left

  // The way from the axis to a place, across it.
  Vector3d away(const Vector3d& place) const {
    const Vector3d to = place - from;
    return to - along * along.dot(to);
  }
};

int half_of(const Sheet& sheet, int face, int edge) {
  return sheet.half(2 * edge).face == face ? 2 * edge : 2 * edge + 1;
}

Vector3d centre_of(const Sheet& sheet, int face) {
  Vector3d sum = Vector3d::Zero();
  const auto corners = sheet.corners_of(face);
  for (const int v : corners) sum += sheet.folded[std::size_t(v)];
  return sum / double(corners.size());
}

// All creases that lie on the axis.
std::vector<int> creases_on(const Sheet& sheet, const Axis& axis) {
  const double close = 1e-7 * size_of(sheet.flat);
  std::vector<int> creases;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    const auto on = [&](int half) {
      return axis.away(sheet.folded[std::size_t(sheet.origin(half))]).norm() < close;
    };
    if (on(2 * e) && on(2 * e + 1)) creases.push_back(e);
  }
  return creases;
}

void note_angle(Sheet& sheet, int edge, double angle) {
  // Beyond half a turn it is the same fold from the other side.
  if (angle > pi + 1e-9) angle -= 2.0 * pi;
  if (angle < -pi - 1e-9) angle += 2.0 * pi;
  sheet.fold_angles[std::size_t(edge)] = angle;
  sheet.creases[std::size_t(edge)] = std::abs(angle) < 1e-9 ? Crease::flat
                                     : angle > 0.0          ? Crease::valley
                                                            : Crease::mountain;
}

// Which flaps turn: that of the face, those chosen, and if wanted those that lie where it lies.
Faces turning(const Sheet& sheet, const Swing& swing, const Axis& axis,
              const std::vector<int>& creases, const std::vector<int>& flap) {
  std::vector<bool> chosen(std::size_t(1 + *std::max_element(flap.begin(), flap.end())), false);
  chosen[std::size_t(flap[std::size_t(swing.face)])] = true;
  for (const int face : swing.with) chosen[std::size_t(flap[std::size_t(face)])] = true;
  const Vector3d way = axis.away(centre_of(sheet, swing.face)).normalized();
  for (const int e : creases) {
    for (const int face : {sheet.half(2 * e).face, sheet.half(2 * e + 1).face}) {
      const bool alike = axis.away(centre_of(sheet, face)).normalized().dot(way) > 1.0 - 1e-9;
      if (swing.all && alike) chosen[std::size_t(flap[std::size_t(face)])] = true;
    }
  }
  Faces faces;
  for (const int k : flap) faces.push_back(chosen[std::size_t(k)]);
  return faces;
}

bool is_pinned_among(const Swing& swing, const Faces& faces, bool turning) {
  return std::any_of(swing.pinned.begin(), swing.pinned.end(),
                     [&](int face) { return faces[std::size_t(face)] == turning; });
}

void turn_part(Sheet& sheet, const Swing& swing, const Axis& axis, const std::vector<int>& creases,
               const Faces& faces, const std::string& where) {
  const bool held = is_pinned_among(swing, faces, true);
  if (held && is_pinned_among(swing, faces, false)) {
    throw Error(where + ": pins hold both sides of the axis; take one of them off");
  }
  const Eigen::AngleAxisd turn(held ? -swing.angle : swing.angle, axis.along);
  std::vector<bool> moves(sheet.folded.size(), false);
  for (int f = 0; f < sheet.faces(); ++f) {
    if (faces[std::size_t(f)] == held) continue;
    for (const int v : sheet.corners_of(f)) moves[std::size_t(v)] = true;
  }
  for (const int e : creases) {
    // Of each crease one side turns; seen with it to the left, all turn about the same way or back.
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (faces[std::size_t(a)] == faces[std::size_t(b)]) continue;
    const int half = faces[std::size_t(a)] ? 2 * e : 2 * e + 1;
    const Vector3d along = sheet.folded[std::size_t(sheet.target(half))] -
                           sheet.folded[std::size_t(sheet.origin(half))];
    const double change = along.dot(axis.along) > 0.0 ? swing.angle : -swing.angle;
    note_angle(sheet, e, sheet.fold_angles[std::size_t(e)] + change);
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (!moves[v]) continue;
    Vector3d& place = sheet.folded[v];
    if (axis.away(place).norm() > 1e-12) place = axis.from + turn * (place - axis.from);
  }
}

// The held face is led about the axis; all other points move as little as stiff faces allow.
void turn_linked(Sheet& sheet, const Swing& swing, const Axis& axis, int half,
                 const std::string& where) {
  BarNetwork network = rigid_network(sheet, 0.0);
  network.pinned.assign(sheet.folded.size(), false);
  std::vector<int> held = swing.pinned;
  if (held.empty()) held.push_back(sheet.half(half ^ 1).face);
  held.push_back(swing.face);
  for (const int face : held) {
    for (const int v : sheet.corners_of(face)) network.pinned[std::size_t(v)] = true;
  }
  const int stages = std::max(1, int(std::ceil(std::abs(swing.angle) / largest_stage)));
  const Eigen::AngleAxisd turn(swing.angle / stages, axis.along);
  for (int stage = 0; stage < stages; ++stage) {
    for (const int v : sheet.corners_of(swing.face)) {
      Vector3d& place = sheet.folded[std::size_t(v)];
      if (axis.away(place).norm() > 1e-12) place = axis.from + turn * (place - axis.from);
    }
    Relaxed relaxed = relax(network, std::move(sheet.folded), {.most_steps = swing.most_steps});
    sheet.folded = std::move(relaxed.places);
    if (std::max(relaxed.strain, relaxed.planarity) > swing.strain) {
      throw Error(where + ": the paper would stretch; what the face hangs on cannot follow so far");
    }
  }
  const auto angles = edge_angles(sheet, sheet.folded);
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    // A fold that is shut keeps its side.
    const double old = sheet.fold_angles[std::size_t(e)], angle = angles[std::size_t(e)];
    const bool shut = std::abs(angle) > pi - 1e-6 && std::abs(old) > 0.5 * pi;
    note_angle(sheet, e, shut ? std::copysign(angle, old) : angle);
  }
}

}  // namespace

Sheet swung(Sheet sheet, const Swing& swing, const std::string& where) {
  const int half = half_of(sheet, swing.face, swing.axis);
  if (sheet.half(half).face != swing.face || sheet.is_border(swing.axis)) {
    throw Error(where + ": the axis is no crease of the face that is held");
  }
  const Vector3d from = sheet.folded[std::size_t(sheet.origin(half))];
  const Axis axis{from, (sheet.folded[std::size_t(sheet.target(half))] - from).normalized()};
  const auto creases = creases_on(sheet, axis);
  const auto flap = flaps_of(sheet, Faces(std::size_t(sheet.faces()), true), creases);
  const Faces faces = turning(sheet, swing, axis, creases, flap);
  const bool parts = !faces[std::size_t(sheet.half(half ^ 1).face)];
  if (parts) turn_part(sheet, swing, axis, creases, faces, where);
  if (!parts) turn_linked(sheet, swing, axis, half, where);
  return sheet;
}

}  // namespace hada
