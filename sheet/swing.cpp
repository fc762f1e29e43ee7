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

// The way from an axis to a place, across it; the axis has unit length.
Vector3d across(const Vector3d& from, const Vector3d& along, const Vector3d& place) {
  const Vector3d to = place - from;
  return to - along * along.dot(to);
}

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
std::vector<int> creases_on(const Sheet& sheet, const Vector3d& from, const Vector3d& along) {
  const double close = 1e-7 * size_of(sheet.flat);
  std::vector<int> creases;
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    const auto on = [&](int half) {
      return across(from, along, sheet.folded[std::size_t(sheet.origin(half))]).norm() < close;
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
Faces turning(const Sheet& sheet, const Swing& swing, const Vector3d& from, const Vector3d& along,
              const std::vector<int>& creases) {
  const auto flap = flaps_of(sheet, Faces(std::size_t(sheet.faces()), true), creases);
  std::vector<bool> chosen(std::size_t(1 + *std::max_element(flap.begin(), flap.end())), false);
  chosen[std::size_t(flap[std::size_t(swing.face)])] = true;
  for (const int face : swing.with) chosen[std::size_t(flap[std::size_t(face)])] = true;
  const auto way_of = [&](int face) -> Vector3d {
    return across(from, along, centre_of(sheet, face)).normalized();
  };
  const Vector3d way = way_of(swing.face);
  for (const int e : creases) {
    for (const int face : {sheet.half(2 * e).face, sheet.half(2 * e + 1).face}) {
      const bool alike = way_of(face).dot(way) > 1.0 - 1e-9;
      if (swing.all && alike) chosen[std::size_t(flap[std::size_t(face)])] = true;
    }
  }
  Faces faces;
  for (const int k : flap) faces.push_back(chosen[std::size_t(k)]);
  return faces;
}

// What follows the face that is held: the rest of the paper, but for what stays.
BarNetwork followers(const Sheet& sheet, const Swing& swing, int beyond) {
  BarNetwork network = rigid_network(sheet, 0.0);
  network.pinned.assign(sheet.folded.size(), false);
  std::vector<int> held = swing.pinned;
  if (held.empty()) held.push_back(beyond);
  held.push_back(swing.face);
  for (const int face : held) {
    for (const int v : sheet.corners_of(face)) network.pinned[std::size_t(v)] = true;
  }
  return network;
}

}  // namespace

Swinging::Swinging(Sheet sheet, Swing swing, const std::vector<FaceOrder>& order,
                   const std::string& where)
    : swing_(std::move(swing)), now_{std::move(sheet)} {
  const Sheet& paper = now_.sheet;
  const int half = half_of(paper, swing_.face, swing_.axis);
  if (paper.half(half).face != swing_.face || paper.is_border(swing_.axis)) {
    throw Error(where + ": the axis is no crease of the face that is held");
  }
  from_ = paper.folded[std::size_t(paper.origin(half))];
  along_ = (paper.folded[std::size_t(paper.target(half))] - from_).normalized();
  now_.shortly_before = paper.folded;
  creases_ = creases_on(paper, from_, along_);
  faces_ = turning(paper, swing_, from_, along_, creases_);
  const int beyond = paper.half(half ^ 1).face;
  const double size = size_of(paper.flat);
  if (faces_[std::size_t(beyond)]) {
    followers_.emplace(followers(paper, swing_, beyond),
                       RelaxOptions{.most_steps = swing_.most_steps});
    // Faces that stretch a little may pass by as much.
    watch_.emplace(paper, order, Faces{}, std::max(1e-6, swing_.strain) * size);
    return;
  }
  const auto is_pinned = [&](bool turns) {
    return std::any_of(swing_.pinned.begin(), swing_.pinned.end(),
                       [&](int face) { return faces_[std::size_t(face)] == turns; });
  };
  other_side_ = is_pinned(true);
  if (other_side_ && is_pinned(false)) {
    throw Error(where + ": pins hold both sides of the axis; take one of them off");
  }
  watch_.emplace(paper, order, faces_, 1e-6 * size);
}

void Swinging::further(double angle) {
  if (followers_) {
    turn_linked(angle);
  } else {
    turn_part(angle);
  }
}

void Swinging::turn_part(double angle) {
  Sheet& sheet = now_.sheet;
  Faces moving = faces_;
  if (other_side_) moving.flip();
  Reached reached = turn_faces(sheet, *watch_, moving, from_, along_, other_side_ ? -angle : angle);
  const double turned = reached.share * angle;
  now_.angle += turned;
  now_.met = reached.met;
  now_.shortly_before = std::move(reached.shortly_before);
  for (const int e : creases_) {
    // Of each crease one side turns; seen with it to the left, all turn about the same way or back.
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (faces_[std::size_t(a)] == faces_[std::size_t(b)]) continue;
    const int half = faces_[std::size_t(a)] ? 2 * e : 2 * e + 1;
    const Vector3d along = sheet.folded[std::size_t(sheet.target(half))] -
                           sheet.folded[std::size_t(sheet.origin(half))];
    const double change = along.dot(along_) > 0.0 ? turned : -turned;
    note_angle(sheet, e, sheet.fold_angles[std::size_t(e)] + change);
  }
}

// The held face is led about the axis; all other points move as little as stiff faces allow.
std::optional<std::vector<Vector3d>> Swinging::led(double angle) {
  const Eigen::AngleAxisd turn(angle, along_);
  auto places = now_.sheet.folded;
  for (const int v : now_.sheet.corners_of(swing_.face)) {
    Vector3d& place = places[std::size_t(v)];
    if (across(from_, along_, place).norm() > 1e-12) place = from_ + turn * (place - from_);
  }
  Relaxed relaxed = followers_->from(std::move(places));
  if (std::max(relaxed.strain, relaxed.planarity) > swing_.strain) return {};
  return std::move(relaxed.places);
}

void Swinging::turn_linked(double angle) {
  Sheet& sheet = now_.sheet;
  now_.met.reset();
  now_.stuck = false;
  now_.shortly_before = sheet.folded;
  double stage = angle / std::max(1.0, std::ceil(std::abs(angle) / largest_stage));
  for (double left = angle; std::abs(left) > least_stage;) {
    auto places = led(stage);
    now_.stuck = !places;
    if (now_.stuck) break;
    const auto met = watch_->meets(*places);
    if (met) now_.met = met;
    if (!met) {
      watch_->accept(*places);
      now_.shortly_before = std::move(sheet.folded);
      sheet.folded = std::move(*places);
      now_.angle += stage;
      left -= stage;
    }
    if (!now_.met) continue;
    if (std::abs(stage) < least_stage) break;
    stage *= 0.5;  // towards the place where they meet
  }
  const auto angles = edge_angles(sheet, sheet.folded);
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) continue;
    // A fold that is shut keeps its side.
    const double old = sheet.fold_angles[std::size_t(e)], now = angles[std::size_t(e)];
    const bool shut = std::abs(now) > pi - 1e-6 && std::abs(old) > 0.5 * pi;
    note_angle(sheet, e, shut ? std::copysign(now, old) : now);
  }
}

}  // namespace hada
