#include "measure/crease_ends.h"

#include <algorithm>

#include <Eigen/Dense>

namespace hada {
namespace {

using Eigen::Vector2d;

struct Line {
  Vector2d normal;
  double offset;
};

double distance_to_side(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

// The point nearest to several lines.
Vector2d common_point(const std::vector<Line>& lines, const Vector2d& otherwise) {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Vector2d right = Vector2d::Zero();
  for (const Line& line : lines) {
    matrix += line.normal * line.normal.transpose();
    right += line.offset * line.normal;
  }
  if (matrix.determinant() < 1e-3 * matrix.trace() * matrix.trace()) return otherwise;
  return matrix.ldlt().solve(right);
}

}  // namespace

CreaseEnds ends_of(const std::vector<CreaseCandidate>& candidates,
                   const std::vector<Vector2d>& outline, double tolerance) {
  struct End {
    std::size_t crease;
    Vector2d place;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& [first, second, edge, from, to] = candidates[i];
    const Vector2d foot = edge.offset * edge.normal;
    ends.push_back({i, foot + from * along(edge)});
    ends.push_back({i, foot + to * along(edge)});
  }
  const auto line_of = [&](std::size_t crease) {
    return Line{candidates[crease].edge.normal, candidates[crease].edge.offset};
  };
  CreaseEnds result;
  result.of.assign(candidates.size(), {-1, -1});
  std::vector<int> vertex(ends.size(), -1);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (vertex[i] >= 0) continue;
    int side = -1;
    double nearest = tolerance;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const double distance =
          distance_to_side(ends[i].place, outline[k], outline[(k + 1) % outline.size()]);
      if (distance >= nearest) continue;
      nearest = distance;
      side = int(k);
    }
    std::vector<Line> lines{line_of(ends[i].crease)};
    std::vector<std::size_t> members{i};
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      if (vertex[j] >= 0 || ends[j].crease == ends[i].crease) continue;
      if ((ends[j].place - ends[i].place).norm() > 2.0 * tolerance) continue;
      members.push_back(j);
      lines.push_back(line_of(ends[j].crease));
    }
    if (side >= 0 && members.size() < 3) {
      const Vector2d a = outline[std::size_t(side)];
      const Vector2d way = (outline[(std::size_t(side) + 1) % outline.size()] - a).normalized();
      lines = {lines[0], Line{Vector2d(-way.y(), way.x()), a.dot(Vector2d(-way.y(), way.x()))}};
      members = {i};
    } else {
      side = -1;
    }
    const int number = int(result.places.size());
    result.places.push_back(common_point(lines, ends[i].place));
    result.side.push_back(side);
    for (const std::size_t m : members) vertex[m] = number;
  }
  for (std::size_t i = 0; i < ends.size(); ++i) result.of[i / 2][i % 2] = vertex[i];
  return result;
}

}  // namespace hada
