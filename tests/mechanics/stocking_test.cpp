#include "mechanics/stocking.h"

#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

const StockingShape shape{.wales = 48, .leg = 10, .heel = 12, .foot = 8, .toe = 9};

bool is_heel(int course) {
  return course >= shape.leg && course < shape.leg + shape.heel;
}

TEST(Stocking, IsClosedAtTheToe) {
  const ShellNet net = stocking_net(shape);
  // A bag: one border, which is the first round, and as a disc has, one face and point more than
  // sides.
  std::map<std::pair<int, int>, int> sides;
  const auto cells = cells_of(net);
  for (const ShellCell& cell : cells) {
    const auto n = cell.corners.size();
    EXPECT_EQ(cell.springs.size(), n);
    for (std::size_t k = 0; k < n; ++k) ++sides[{cell.corners[k], cell.corners[(k + 1) % n]}];
  }
  int border = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    if (sides.count({side.second, side.first}) > 0) continue;
    ++border;
    EXPECT_EQ(net.course[std::size_t(side.first)], 0);
    EXPECT_EQ(net.course[std::size_t(side.second)], 0);
  }
  EXPECT_EQ(border, shape.wales);
  EXPECT_EQ(net.points() - int(net.springs.size()) + int(cells.size()), 1);
}

TEST(Stocking, GivesEveryLoopItsNeighbours) {
  const ShellNet net = stocking_net(shape);
  const auto n = std::size_t(net.points());
  std::vector<int> along(n, 0), wrapped(n, 0), above(n, 0), below(n, 0);
  for (int k = 0; k < int(net.springs.size()); ++k) {
    const auto& s = net.springs[std::size_t(k)];
    const auto from = std::size_t(s.from), to = std::size_t(s.to);
    if (k >= net.along) {
      ++above[from], ++below[to];
    } else {
      const bool own = net.course[from] == s.course;
      ++(own ? along : wrapped)[from];
      ++(net.course[to] == s.course ? along : wrapped)[to];
    }
    // What runs on comes back.
    if (s.after >= 0) {
      EXPECT_EQ(net.springs[std::size_t(s.after)].before, k);
    }
    if (s.after >= 0) {
      EXPECT_EQ(net.springs[std::size_t(s.after)].from, s.to);
    }
  }
  int decreases = 0, wraps = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    EXPECT_EQ(along[i], 2) << i;
    EXPECT_EQ(above[i], 1) << i;
    const int course = net.course[i];
    if (course == 0) {
      EXPECT_EQ(below[i], 0);
    }
    if (course > 0 && course < shape.leg + shape.heel + shape.foot) {
      EXPECT_EQ(below[i], 1);
    }
    if (course >= shape.leg + shape.heel + shape.foot) {
      EXPECT_GE(below[i], 1);
      EXPECT_LE(below[i], 2);
      decreases += below[i] - 1;
    }
    wraps += wrapped[i];
  }
  EXPECT_EQ(wraps, 2 * shape.heel);  // both ends of every short row
  EXPECT_EQ(along[n - 1], 0);
  EXPECT_EQ(below[n - 1], shape.wales - decreases);  // the last round, drawn together
}

TEST(Stocking, IsLongerAtTheHeelOnly) {
  const ShellNet net = stocking_net(shape);
  std::map<int, int> rows;
  for (std::size_t i = 0; i < net.course.size(); ++i) {
    rows[net.wale[i]] += is_heel(net.course[i]);
  }
  EXPECT_EQ(rows[0], 0);
  EXPECT_EQ(rows[shape.wales / 2], shape.heel);
  for (int w = 1; w < shape.wales / 2; ++w) {
    EXPECT_GE(rows[w], rows[w - 1]);
    EXPECT_EQ(rows[w], rows[shape.wales - w]);  // both sides alike
    EXPECT_EQ(rows[w] % 2, 0);                  // knitted out and back
  }
  // A third of the back is left where the heel is narrowest.
  std::map<int, int> of_course;
  for (const int course : net.course) ++of_course[course];
  EXPECT_NEAR(of_course[shape.leg + shape.heel / 2], shape.wales / 6, 4);
}

TEST(Stocking, NarrowsAsAHemisphereDoes) {
  const ShellNet net = stocking_net(shape);
  std::map<int, int> of_course;
  for (const int course : net.course) ++of_course[course];
  for (int j = 1; j <= shape.toe; ++j) {
    const double t = 0.5 * std::numbers::pi * j / (shape.toe + 1.0);
    EXPECT_NEAR(of_course[shape.leg + shape.heel + shape.foot + j - 1], shape.wales * std::cos(t),
                0.51);
  }
}

TEST(Stocking, RefusesWhatCannotBeKnitted) {
  EXPECT_THROW(stocking_net({.wales = 8}), Error);
  EXPECT_THROW(stocking_net({.heel = 3}), Error);
  EXPECT_THROW(stocking_net({.toe = 1}), Error);
}

}  // namespace
}  // namespace hada
