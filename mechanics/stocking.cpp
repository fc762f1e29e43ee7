#include "mechanics/stocking.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.h"

namespace hada {
namespace {

class Knitting {
 public:
  explicit Knitting(int wales) : top_(std::size_t(wales), -1) {
    for (int w = 0; w < wales; ++w) alive_.push_back(w);
  }

  int alive() const { return int(alive_.size()); }

  void round() {
    std::vector<int> stitches;
    for (const int wale : alive_) stitches.push_back(stitch(wale));
    yarn(stitches, true);
    ++course_;
  }

  /// A row over the wales from `first` to `last`, wrapped around those beside it.
  void row(int first, int last) {
    std::vector<int> stitches{top(first - 1)};
    for (int wale = first; wale <= last; ++wale) stitches.push_back(stitch(wale));
    stitches.push_back(top(last + 1));
    yarn(stitches, false);
    ++course_;
  }

  /// Ends `count` wales, evenly spread, shifted from round to round: the next round knits each
  /// together with the wale before it.
  void narrow(int count) {
    constexpr double golden = 0.6180339887498949;
    std::vector<bool> ends(alive_.size(), false);
    const double apart = double(alive_.size()) / std::max(count, 1);
    const double shift = std::fmod(golden * course_, 1.0);
    for (int k = 0; k < count; ++k) {
      ends[std::size_t((k + shift) * apart) % alive_.size()] = true;
    }
    std::vector<int> left;
    for (std::size_t k = 0; k < alive_.size(); ++k) {
      if (!ends[k]) {
        left.push_back(alive_[k]);
        continue;
      }
      const int before = alive_[(k + alive_.size() - 1) % alive_.size()];
      joined_.emplace_back(alive_[k], before);
    }
    alive_ = std::move(left);
  }

  /// Draws the last round together.
  ShellNet closed() {
    const int tip = int(net_.course.size());
    net_.course.push_back(course_), net_.wale.push_back(0);
    for (const int wale : alive_) ups_.push_back({top(wale), tip, course_ - 1});
    net_.along = int(net_.springs.size());
    net_.springs.insert(net_.springs.end(), ups_.begin(), ups_.end());
    return std::move(net_);
  }

 private:
  int& top(int wale) { return top_[std::size_t(wale)]; }

  int stitch(int wale) {
    const int point = int(net_.course.size());
    net_.course.push_back(course_), net_.wale.push_back(wale);
    const auto draw_through = [&](int below) {
      if (below >= 0) ups_.push_back({below, point, net_.course[std::size_t(below)]});
    };
    draw_through(top(wale));
    for (const auto& [ended, into] : joined_) {
      if (into == wale) draw_through(top(ended));
    }
    std::erase_if(joined_, [&](const auto& pair) { return pair.second == wale; });
    top(wale) = point;
    return point;
  }

  void yarn(const std::vector<int>& stitches, bool round) {
    const int first = int(net_.springs.size());
    const int count = int(stitches.size()) - (round ? 0 : 1);
    for (int k = 0; k < count; ++k) {
      ShellSpring spring{stitches[std::size_t(k)], stitches[std::size_t(k + 1) % stitches.size()],
                         course_};
      if (round || k > 0) spring.before = first + (k + count - 1) % count;
      if (round || k + 1 < count) spring.after = first + (k + 1) % count;
      net_.springs.push_back(spring);
    }
  }

  ShellNet net_;
  std::vector<ShellSpring> ups_;
  std::vector<int> top_;                     // the last stitch of each wale
  std::vector<int> alive_;                   // wales
  std::vector<std::pair<int, int>> joined_;  // wales that ended, and those they go into
  int course_ = 0;
};

}  // namespace

ShellNet stocking_net(const StockingShape& shape) {
  if (shape.wales < 16 || shape.leg < 2 || shape.foot < 2 || shape.toe < 3 || shape.heel < 0 ||
      shape.heel % 2 != 0) {
    throw Error(
        "a stocking needs 16 wales, 2 rounds of leg and foot and 3 of toe at least, and an even "
        "number of heel rows");
  }
  Knitting knitting(shape.wales);
  for (int j = 0; j < shape.leg; ++j) knitting.round();
  const int half = shape.heel / 2, edge = (shape.wales + 3) / 4;
  for (int j = 0; j < shape.heel; ++j) {
    const int depth = j < half ? j : shape.heel - 1 - j;
    const int narrower = depth * (shape.wales / 6) / std::max(half - 1, 1);
    knitting.row(edge + narrower, shape.wales - edge - narrower);
  }
  for (int j = 0; j < shape.foot; ++j) knitting.round();
  for (int j = 1; j <= shape.toe; ++j) {
    const double t = 0.5 * std::numbers::pi * j / (shape.toe + 1.0);
    const int wanted = std::max(3, int(std::lround(shape.wales * std::cos(t))));
    knitting.narrow(std::clamp(knitting.alive() - wanted, 0, knitting.alive() / 2));
    knitting.round();
  }
  return knitting.closed();
}

}  // namespace hada
