#include "fit/knit_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/parallel.h"

namespace hada {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double farthest_turn = 3.0 * std::numbers::pi / 180.0;
constexpr int shifts_each_way = 6;
constexpr double shift_step = 0.2;       // in stitches
constexpr double apart = 0.35;           // in stitches: nearer ones are one place
constexpr std::size_t worth_moving = 8;  // of the places that look best at first
constexpr int few_crossings = 100, few_samples = 12, many_samples = 4000;

/// A piece before it is laid into a picture.
struct Pose {
  double log_ratio = 0.0;
  double turn = 0.0;
  Vector2d shift = Vector2d::Zero();  // in wales and courses
};

/// Likeness of a piece as its pose says, at some or at many of its places.
class PosedKnit {
 public:
  PosedKnit(const TrackedPicture& picture, const StitchLook& look, const KnitNet& net,
            const PulledShapes& shapes, int first)
      : picture_(picture), look_(look), net_(net), shapes_(shapes), first_(first) {
    // Not the same wales of all courses.
    every_ = std::max(1, net.points() / few_crossings);
    while (std::gcd(every_, net.wales) > 1) ++every_;
  }

  BentKnit bent(const Pose& pose) const { return bent(shapes_.at(pose.log_ratio), pose); }
  BentKnit bent(Places places, const Pose& pose) const {
    const double c = std::cos(pose.turn), s = std::sin(pose.turn);
    const Vector3d shift(pose.shift.x() * net_.wale_length, pose.shift.y() * net_.course_length,
                         0.0);
    for (auto& p : places) p = Vector3d(c * p.x() - s * p.y(), s * p.x() + c * p.y(), 0.0) + shift;
    return {net_.courses, net_.wales, std::move(places)};
  }

  double glance(const BentKnit& knit) const {
    return mean_likeness(picture_, look_, knit, first_, {every_, stride(few_samples)});
  }
  double likeness(const Pose& pose) const {
    const int samples = std::max(few_samples, many_samples / net_.points());
    return mean_likeness(picture_, look_, bent(pose), first_, {1, stride(samples)});
  }

 private:
  int stride(int samples) const { return std::max(1, int(look_.courses[0].size()) / samples) | 1; }

  const TrackedPicture& picture_;
  const StitchLook& look_;
  const KnitNet& net_;
  const PulledShapes& shapes_;
  int first_;
  int every_ = 1;
};

/// Turns so near to each other that corners move by half a stitch from one to the next.
std::vector<double> turns_of(const KnitNet& net, const PulledShapes& shapes) {
  double reach = 0.0;
  for (const auto& p : shapes.places[0]) reach = std::max(reach, p.norm());
  const double step = 0.5 * std::min(net.wale_length, net.course_length) / reach;
  const int count = std::max(1, int(std::ceil(farthest_turn / step)));
  std::vector<double> turns;
  for (int k = -count; k <= count; ++k) turns.push_back(farthest_turn * k / count);
  return turns;
}

struct Seen {
  Pose pose;
  double likeness = -1.0;
};

std::vector<Seen> all_seen(const PosedKnit& posed, const KnitNet& net, const PulledShapes& shapes) {
  const auto turns = turns_of(net, shapes);
  constexpr int side = 2 * shifts_each_way + 1;
  std::vector<Seen> seen(shapes.places.size() * turns.size() * side * side);
  for_each_index(int(seen.size()), [&](int k) {
    const int shift = k % (side * side), shape = k / (side * side) % int(shapes.places.size());
    Pose pose{
        shapes.log_ratios[std::size_t(shape)],
        turns[std::size_t(k / (side * side)) / shapes.places.size()],
        shift_step * Vector2d(shift % side - shifts_each_way, shift / side - shifts_each_way)};
    const double likeness = posed.glance(posed.bent(shapes.places[std::size_t(shape)], pose));
    seen[std::size_t(k)] = {pose, likeness};
  });
  return seen;
}

/// Moves a pose along each of its numbers by steps that are halved where none leads upward.
Seen moved(const PosedKnit& posed, Seen seen, double turn_step) {
  constexpr int halvings = 4;
  seen.likeness = posed.likeness(seen.pose);
  double share = 1.0;
  for (int halved = 0; halved < halvings;) {
    bool better = false;
    for (const int number : {0, 1, 2, 3}) {
      for (const double sign : {-share, share}) {
        Pose next = seen.pose;
        if (number < 2) next.shift[number] += 0.5 * shift_step * sign;
        if (number == 2) next.turn += 0.5 * turn_step * sign;
        if (number == 3) next.log_ratio += 0.6 * sign;
        const double likeness = posed.likeness(next);
        if (likeness <= seen.likeness) continue;
        seen = {next, likeness}, better = true;
        break;
      }
    }
    if (!better) share *= 0.5, ++halved;
  }
  return seen;
}

/// The best one of each place, best first.
std::vector<Seen> ones_apart(std::vector<Seen> seen) {
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.likeness > b.likeness; });
  std::vector<Seen> ones;
  for (const Seen& one : seen) {
    if (std::none_of(ones.begin(), ones.end(), [&](const Seen& other) {
          return (other.pose.shift - one.pose.shift).norm() < apart;
        })) {
      ones.push_back(one);
    }
  }
  return ones;
}

}  // namespace

Places PulledShapes::at(double log_ratio) const {
  const auto above = std::size_t(std::upper_bound(log_ratios.begin(), log_ratios.end(), log_ratio) -
                                 log_ratios.begin());
  if (above == 0) return places.front();
  if (above == log_ratios.size()) return places.back();
  const double u =
      (log_ratio - log_ratios[above - 1]) / (log_ratios[above] - log_ratios[above - 1]);
  Places mixed = places[above - 1];
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] += u * (places[above][i] - mixed[i]);
  return mixed;
}

std::vector<PlacedKnit> placements(const TrackedPicture& picture, const StitchLook& look,
                                   const KnitNet& net, const PulledShapes& shapes, int first) {
  if (shapes.places.empty()) return {};
  const PosedKnit posed(picture, look, net, shapes, first);
  auto best = ones_apart(all_seen(posed, net, shapes));
  best.resize(std::min(best.size(), worth_moving));
  const auto turns = turns_of(net, shapes);
  for_each_index(int(best.size()), [&](int k) {
    auto& seen = best[std::size_t(k)];
    seen = moved(posed, seen, turns[1] - turns[0]);
  });
  std::vector<PlacedKnit> placed;
  for (const Seen& seen : ones_apart(best))
    placed.push_back({posed.bent(seen.pose), seen.likeness});
  return placed;
}

}  // namespace hada
