#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/fold.h"

namespace hada {

/// Lines of a crease pattern, added one by one.
struct Lines {
  FoldFrame frame;

  Lines& add(Crease crease, double x1, double y1, double x2, double y2) {
    const int first = int(frame.vertices.size());
    frame.vertices.emplace_back(x1, y1, 0.0);
    frame.vertices.emplace_back(x2, y2, 0.0);
    frame.edges.push_back({first, first + 1});
    frame.assignment.push_back(crease);
    return *this;
  }
  Lines& square(double side) {
    return add(Crease::border, 0, 0, side, 0)
        .add(Crease::border, side, 0, side, side)
        .add(Crease::border, side, side, 0, side)
        .add(Crease::border, 0, side, 0, 0);
  }
};

/// A strip of `count` panels, 1 wide, all of whose folds have the same kind.
inline FoldFrame strip(int count, Crease crease) {
  Lines lines;
  lines.add(Crease::border, 0, 0, count, 0).add(Crease::border, count, 0, count, 1);
  lines.add(Crease::border, count, 1, 0, 1).add(Crease::border, 0, 1, 0, 0);
  for (int i = 1; i < count; ++i) lines.add(crease, i, 0, i, 1);
  return lines.frame;
}

/// One vertex in the middle of a square of side 2 with four folds, at these degrees from +x.
inline FoldFrame vertex_fold(const std::vector<double>& degrees, const std::string& letters) {
  Lines lines;
  lines.square(2.0);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double reach = 1.0 / std::max(std::abs(c), std::abs(s));
    lines.add(Crease(letters[i]), 1, 1, 1 + reach * c, 1 + reach * s);
  }
  return lines.frame;
}

}  // namespace hada
