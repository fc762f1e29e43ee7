#include "sheet/swing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"
#include "mechanics/bar_network.h"
#include "sheet/arrangement.h"
#include "sheet/contact.h"
#include "sheet/flaps.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

using Eigen::Vector3d;
using Faces = std::vector<bool>;

constexpr double pi = std::numbers::pi;
constexpr double largest_stage = pi / 36.0;   // in which what is linked follows
constexpr double least_stage = pi / 18000.0;  // to which the place of a contact is searched

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

void turn_part(Swung& result, const Swing& swing, const std::vector<FaceOrder>& order,
               const Axis& axis, const std::vector<int>& creases, const Faces& faces,
               const std::string& where) {
  Sheet& sheet = result.sheet;
  const bool held = is_pinned_among(swing, faces, true);
  if (held && is_pinned_among(swing, faces, false)) {
    throw Error(where + ": pins hold both sides of the axis; take one of them off");
  }
  Faces moving = faces;
  if (held) moving.flip();
  Reached reached =
      turn_faces(sheet, order, moving, axis.from, axis.along, held ? -swing.angle : swing.angle);
  result.angle = reached.share * swing.angle;
  result.met = reached.met;
  result.shortly_before = std::move(reached.shortly_before);
  for (const int e : creases) {
    // Of each crease one side turns; seen with it to the left, all turn about the same way or back.
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (faces[std::size_t(a)] == faces[std::size_t(b)]) continue;
    const int half = faces[std::size_t(a)] ? 2 * e : 2 * e + 1;
    const Vector3d along = sheet.folded[std::size_t(sheet.target(half))] -
                           sheet.folded[std::size_t(sheet.origin(half))];
    const double change = along.dot(axis.along) > 0.0 ? result.angle : -result.angle;
    note_angle(sheet, e, sheet.fold_angles[std::size_t(e)] + change);
  }
}

// The held face is led about the axis; all other points move as little as stiff faces allow.
void turn_linked(Swung& result, const Swing& swing, const std::vector<FaceOrder>& order,
                 const Axis& axis, int half, const std::string& where) {
  Sheet& sheet = result.sheet;
  BarNetwork network = rigid_network(sheet, 0.0);
  network.pinned.assign(sheet.folded.size(), false);
  std::vector<int> held = swing.pinned;
  if (held.empty()) held.push_back(sheet.half(half ^ 1).face);
  held.push_back(swing.face);
  for (const int face : held) {
    for (const int v : sheet.corners_of(face)) network.pinned[std::size_t(v)] = true;
  }
  const auto led = [&](double angle) {
    const Eigen::AngleAxisd turn(angle, axis.along);
    auto places = sheet.folded;
    for (const int v : sheet.corners_of(swing.face)) {
      Vector3d& place = places[std::size_t(v)];
      if (axis.away(place).norm() > 1e-12) place = axis.from + turn * (place - axis.from);
    }
    Relaxed relaxed = relax(network, std::move(places), {.most_steps = swing.most_steps});
    if (std::max(relaxed.strain, relaxed.planarity) > swing.strain) {
      throw Error(where + ": the paper would stretch; what the face hangs on cannot follow so far");
    }
    return std::move(relaxed.places);
  };
  // Faces that stretch a little may pass by as much.
  ContactWatch watch(sheet, order, {}, std::max(1e-6, swing.strain) * size_of(sheet.flat));
  result.shortly_before = sheet.folded;
  double stage = swing.angle / std::max(1.0, std::ceil(std::abs(swing.angle) / largest_stage));
  for (double left = swing.angle; std::abs(left) > least_stage;) {
    auto places = led(stage);
    const auto met = watch.meets(places);
    if (met) result.met = met;
    if (!met) {
      watch.accept(places);
      result.shortly_before = std::move(sheet.folded);
      sheet.folded = std::move(places);
      result.angle += stage;
      left -= stage;
    }
    if (!result.met) continue;
    if (std::abs(stage) < least_stage) break;
    stage *= 0.5;  // towards the place where they meet
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

Swung swung(Sheet sheet, const Swing& swing, const std::vector<FaceOrder>& order,
            const std::string& where) {
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
  Swung result{std::move(sheet)};
  if (parts) turn_part(result, swing, order, axis, creases, faces, where);
  if (!parts) turn_linked(result, swing, order, axis, half, where);
  return result;
}

}  // namespace hada
