#include "sheet/contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

constexpr double stage = std::numbers::pi / 180.0;  // in which a turn is watched
constexpr double shortly = 0.05;                    // radians before the end of a turn
// The chord of a stage leaves the arc by less than this share of the sheet, also for linked faces
// with stages of five degrees.
constexpr double chord = 1e-3;
constexpr double one_plane = 1e-6;  // of the sheet

std::vector<Plate> plates_at(const std::vector<std::vector<int>>& corners, const Places& places) {
  std::vector<Plate> plates;
  for (const auto& face : corners) plates.push_back(plate_of(face, places));
  return plates;
}

}  // namespace

ContactWatch::ContactWatch(const Sheet& sheet, const std::vector<FaceOrder>& order,
                           const std::vector<bool>& moving, double tolerance)
    : size_(size_of(sheet.flat)), tolerance_(tolerance), accepted_(sheet.folded) {
  std::map<std::pair<int, int>, int> known;
  for (const FaceOrder& o : order) known[{o.face, o.other}] = o.order;
  for (int f = 0; f < sheet.faces(); ++f) corners_.push_back(sheet.corners_of(f));
  const auto plates = plates_of(sheet);
  const auto faces = std::size_t(sheet.faces());
  pairs_.reserve(faces * faces / 2);  // a hand that moves waits for this
  for (int a = 0; a < sheet.faces(); ++a) {
    for (int b = a + 1; b < sheet.faces(); ++b) {
      if (!moving.empty() && moving[std::size_t(a)] == moving[std::size_t(b)]) continue;
      // An order speaks of the printed side of its second face.
      Pair pair{a, b};
      if (known.contains({b, a})) std::swap(pair.face, pair.other);
      const Plate &one = plates[std::size_t(pair.face)], &two = plates[std::size_t(pair.other)];
      pair.crosses = pierce(one, two, tolerance);
      if (const auto place = common_place(one, two, one_plane * size_)) {
        pair.marked = true;
        pair.mark = mark_on(one, *place);
        pair.other_mark = mark_on(two, *place);
        const auto found = known.find({pair.face, pair.other});
        pair.side = found == known.end() ? 0 : found->second;
      } else {
        pair.side = side_of(offset(pair, plates));
      }
      pairs_.push_back(pair);
    }
  }
}

// How far one face of a pair is above the other's plane.
double ContactWatch::offset(const Pair& pair, const std::vector<Plate>& plates) const {
  const Plate &one = plates[std::size_t(pair.face)], &two = plates[std::size_t(pair.other)];
  const Vector3d way = pair.marked
                           ? marked_place(one, pair.mark) - marked_place(two, pair.other_mark)
                           : one.centre - two.centre;
  return two.normal.dot(way);
}

int ContactWatch::side_of(double offset) const {
  if (std::abs(offset) < 1e-3 * tolerance_) return 0;
  return offset > 0.0 ? 1 : -1;
}

// Whether faces that change sides do so face to face, and not beside each other.
bool ContactWatch::passes(const Pair& pair, const Places& places, double offset_there) const {
  const auto plate = [&](int face, const Places& at) {
    return plate_of(corners_[std::size_t(face)], at);
  };
  std::vector<Plate> plates(corners_.size());
  plates[std::size_t(pair.face)] = plate(pair.face, accepted_);
  plates[std::size_t(pair.other)] = plate(pair.other, accepted_);
  const double here = std::abs(offset(pair, plates)), there = std::abs(offset_there);
  const double share = here / (here + there);
  Places between = accepted_;
  for (const int face : {pair.face, pair.other}) {
    for (const int v : corners_[std::size_t(face)]) {
      const std::size_t k = std::size_t(v);
      between[k] = (1.0 - share) * accepted_[k] + share * places[k];
    }
  }
  return common_place(plate(pair.face, between), plate(pair.other, between), chord * size_)
      .has_value();
}

std::optional<std::array<int, 2>> ContactWatch::meets(const Places& places) const {
  const auto plates = plates_at(corners_, places);
  for (const Pair& pair : pairs_) {
    const Plate &one = plates[std::size_t(pair.face)], &two = plates[std::size_t(pair.other)];
    if (!pair.crosses && pierce(one, two, tolerance_)) return {{pair.face, pair.other}};
    const double off = offset(pair, plates);
    if (side_of(off) * pair.side >= 0) continue;
    if (passes(pair, places, off)) return {{pair.face, pair.other}};
  }
  return {};
}

void ContactWatch::accept(const Places& places) {
  const auto plates = plates_at(corners_, places);
  for (Pair& pair : pairs_) {
    const Plate &one = plates[std::size_t(pair.face)], &two = plates[std::size_t(pair.other)];
    pair.crosses = pair.crosses && pierce(one, two, tolerance_);
    if (const int side = side_of(offset(pair, plates)); side != 0) pair.side = side;
  }
  accepted_ = places;
}

Reached turn_faces(Sheet& sheet, ContactWatch& watch, const std::vector<bool>& moving,
                   const Vector3d& from, const Vector3d& along, double angle) {
  std::vector<bool> moves(sheet.folded.size(), false);
  for (int f = 0; f < sheet.faces(); ++f) {
    if (!moving[std::size_t(f)]) continue;
    for (const int v : sheet.corners_of(f)) moves[std::size_t(v)] = true;
  }
  const Places start = sheet.folded;
  const double on_axis = 1e-12 * size_of(sheet.flat);
  const auto places_at = [&](double share) {
    const Eigen::AngleAxisd turn(share * angle, along);
    Places places = start;
    for (std::size_t v = 0; v < places.size(); ++v) {
      const Vector3d to = start[v] - from;
      if (moves[v] && (to - along * along.dot(to)).norm() > on_axis) places[v] = from + turn * to;
    }
    return places;
  };
  Reached reached;
  const int stages = std::max(1, int(std::ceil(std::abs(angle) / stage)));
  for (int k = 1; k <= stages && !reached.met; ++k) {
    const Places places = places_at(double(k) / stages);
    reached.met = watch.meets(places);
    if (!reached.met) watch.accept(places);
    if (!reached.met) continue;
    double low = double(k - 1) / stages, high = double(k) / stages;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = 0.5 * (low + high);
      const auto met = watch.meets(places_at(middle));
      (met ? high : low) = middle;
      if (met) reached.met = met;
    }
    reached.share = low;
  }
  sheet.folded = places_at(reached.share);
  const double back = std::abs(angle) > 0.0 ? std::min(shortly / std::abs(angle), 0.5) : 0.0;
  reached.shortly_before = places_at(reached.share * (1.0 - back));
  watch.accept(sheet.folded);
  return reached;
}

Reached turn_faces(Sheet& sheet, const std::vector<FaceOrder>& order,
                   const std::vector<bool>& moving, const Vector3d& from, const Vector3d& along,
                   double angle) {
  ContactWatch watch(sheet, order, moving, 1e-6 * size_of(sheet.flat));
  return turn_faces(sheet, watch, moving, from, along, angle);
}

}  // namespace hada
