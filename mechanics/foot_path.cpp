#include "mechanics/foot_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/error.h"
#include "mechanics/drawn_over.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double right_angle = 0.5 * std::numbers::pi;
constexpr int pieces = 48;              // that paths are measured in
constexpr double toes = 0.22;           // of the way from the pivot to the tip
constexpr double before_instep = 0.05;  // the pivot before the front of the ankle, of that way

template <class Place>
double length_of(const Place& place) {
  double sum = 0.0;
  Vector3d last = place(0.0);
  for (int k = 1; k <= pieces; ++k) {
    const Vector3d next = place(double(k) / pieces);
    sum += (next - last).norm();
    last = next;
  }
  return sum;
}

}  // namespace

FootPath::FootPath(const Body& body, int axis, std::optional<double> top_mm)
    : body_(body), axis_(axis), up_(Vector3d::Unit(axis)) {
  Vector3d low = body.mesh().vertices_mm[0], high = low;
  for (const Vector3d& v : body.mesh().vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  reach_ = (high - low).norm();
  const double height = high[axis] - low[axis];
  top_ = top_mm.value_or(high[axis] - 0.05 * height);
  girth_mm_ = HUGE_VAL;
  for (int k = 2; k <= pieces; ++k) {
    const double at = low[axis] + 0.45 * height * k / pieces;
    const double girth = outline_at(body, axis, at).length;
    if (girth < girth_mm_) girth_mm_ = girth, ankle_ = at;
  }
  if (!(top_ > ankle_ && top_ <= high[axis])) {
    throw Error(fmt::format("the top of the stocking must lie on the leg, from {:g} to {:g} mm",
                            ankle_, high[axis]));
  }
  find_forward();
  follow_foot();
  measure();
}

void FootPath::find_forward() {
  const Vector3d middle = outline_at(body_, axis_, ankle_).middle;
  double farthest = 0.0;
  for (const Vector3d& v : body_.mesh().vertices_mm) {
    if (v[axis_] > ankle_) continue;
    Vector3d way = v - middle;
    way[axis_] = 0.0;
    if (way.norm() > farthest) farthest = way.norm(), forward_ = way.normalized();
  }
  const auto expect_foot = [](bool there) {
    if (!there) throw Error("the body has no foot at its low end: draw a tube over it, or turn it");
  };
  // Farther than it is wide: else what lies below is the end of a leg.
  expect_foot(farthest > girth_mm_ / 4.0);
  side_ = up_.cross(forward_);
  const Vector3d front = leaves(middle, forward_).place;
  const double ahead = farthest - (front - middle).norm();
  expect_foot(ahead > 0.0);
  pivot_ = front + before_instep * ahead * forward_;
}

void FootPath::follow_foot() {
  foot_from_ = pivot_.dot(forward_);
  double tip = foot_from_;
  for (const Vector3d& v : body_.mesh().vertices_mm) {
    if (v[axis_] <= ankle_) tip = std::max(tip, v.dot(forward_));
  }
  toes_from_ = tip - toes * (tip - foot_from_);
  middles_ = {heel(1.0).middle};
  for (int k = 1; k <= pieces; ++k) {
    middles_.push_back(centred(middles_.back() + (toes_from_ - foot_from_) / pieces * forward_));
  }
}

void FootPath::measure() {
  heel_mm_ = length_of([&](double share) { return place(heel(share), 2.0 * right_angle).place; });
  toe_mm_ = 0.0;
  for (int k = 0; k < 4; ++k) {
    toe_mm_ += 0.25 * length_of([&](double share) { return toe(share, right_angle * k).place; });
  }
}

MeshPlace FootPath::leaves(const Vector3d& from, const Vector3d& way) const {
  const MeshPlace hit = body_.tree().first_hit(from, way);
  if (hit.triangle < 0) {
    throw Error(
        fmt::format("the body is open beside ({:.4g}, {:.4g}, {:.4g}) mm: a stocking needs "
                    "a leg with a foot that is closed around",
                    from.x(), from.y(), from.z()));
  }
  return hit;
}

Vector3d FootPath::centred(Vector3d middle) const {
  for (const Vector3d& way : {up_, side_}) {
    middle += 0.5 * (leaves(middle, way).distance - leaves(middle, -way).distance) * way;
  }
  return middle;
}

LimbSection FootPath::leg(double share) const {
  const double height = top_ + share * (ankle_ - top_);
  return {outline_at(body_, axis_, height).middle, forward_, side_};
}

LimbSection FootPath::heel(double share) const {
  const double turn = right_angle * share;
  const Vector3d back = -std::cos(turn) * forward_ - std::sin(turn) * up_;
  const double far = reach_ - leaves(pivot_ + reach_ * back, -back).distance;
  const double near = body_.depth(pivot_) > 0.0 ? 0.0 : leaves(pivot_, back).distance;
  return {pivot_ + 0.5 * (near + far) * back, -back, side_};
}

LimbSection FootPath::foot(double share) const {
  const double at = share * pieces;
  const int k = std::clamp(int(at), 0, pieces - 1);
  const auto& m = middles_;
  const Vector3d middle =
      m[std::size_t(k)] + (at - k) * (m[std::size_t(k + 1)] - m[std::size_t(k)]);
  return {middle, up_, side_};
}

MeshPlace FootPath::place(const LimbSection& section, double turn) const {
  return leaves(section.middle, std::cos(turn) * section.out + std::sin(turn) * section.across);
}

MeshPlace FootPath::toe(double share, double turn) const {
  const double rise = right_angle * share;
  const Vector3d out = std::cos(turn) * up_ + std::sin(turn) * side_;
  return leaves(middles_.back(), std::cos(rise) * out + std::sin(rise) * forward_);
}

}  // namespace hada
