#include "measure/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Dense>

#include "core/quantile.h"
#include "measure/closure.h"
#include "measure/crease_edge.h"
#include "measure/crease_ends.h"
#include "measure/lit_facets.h"
#include "measure/outline.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;

// Where two facets touch: places between their pixels.
std::map<std::pair<int, int>, std::vector<Vector2d>> borders(const Grid<int>& label,
                                                             const Extent& extent) {
  std::map<std::pair<int, int>, std::vector<Vector2d>> all;
  for (int row = 0; row < label.rows(); ++row) {
    for (int col = 0; col < label.cols(); ++col) {
      for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}}) {
        if (!label.contains(row + down, col + right)) continue;
        const int a = label(row, col), b = label(row + down, col + right);
        if (a < 0 || b < 0 || a == b) continue;
        all[std::minmax(a, b)].push_back(extent.place(row + 0.5 * down, col + 0.5 * right));
      }
    }
  }
  return all;
}

// A line through scattered places, the normal towards `behind`.
CreaseEdge line_through(const std::vector<Vector2d>& places, double width) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& p : places) mean += p / double(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vector2d& p : places) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  CreaseEdge edge;
  edge.normal = axes.eigenvectors().col(0);
  edge.offset = edge.normal.dot(mean);
  edge.width = width;
  return edge;
}

std::vector<StepSample> samples_near(const Surface& surface, const Facets& facets,
                                     const CreaseCandidate& candidate, double reach) {
  const Vector2d &one = facets.facets[std::size_t(candidate.first)].slope,
                 &two = facets.facets[std::size_t(candidate.second)].slope;
  const Vector2d step = two - one;
  // A mean over an hour-glass of pixels would do; all pixels within the reach are taken as they
  // are.
  std::vector<StepSample> samples;
  const auto& edge = candidate.edge;
  const double trimmed = std::min(reach, 0.25 * (candidate.to - candidate.from));
  for (int row = 0; row < surface.extent.rows; ++row) {
    for (int col = 0; col < surface.extent.cols; ++col) {
      const int label = facets.label(row, col);
      if (label != candidate.first && label != candidate.second) continue;
      const Vector2d place = surface.extent.place(row, col);
      if (std::abs(edge.normal.dot(place) - edge.offset) > reach) continue;
      const double t = along(edge).dot(place);
      if (t < candidate.from + trimmed || t > candidate.to - trimmed) continue;
      const auto& n = surface.normals(row, col);
      const Vector2d slope = -(n.head<2>() / n.z()).cast<double>();
      samples.push_back({place, (slope - one).dot(step) / step.squaredNorm()});
    }
  }
  return samples;
}

CreaseCandidate candidate_of(const Surface& surface, const Facets& facets, std::pair<int, int> pair,
                             const std::vector<Vector2d>& border) {
  const double pitch = surface.extent.pitch;
  CreaseCandidate candidate{pair.first, pair.second, line_through(border, pitch), 0.0, 0.0};
  CreaseEdge& edge = candidate.edge;
  // The slope across a crease jumps along its normal: a ridge and a valley differ in sign only.
  const auto extend = [&] {
    candidate.from = 1e300;
    candidate.to = -1e300;
    for (const Vector2d& p : border) {
      candidate.from = std::min(candidate.from, along(edge).dot(p));
      candidate.to = std::max(candidate.to, along(edge).dot(p));
    }
  };
  extend();
  // From the first facet to the second.
  double side = 0.0;
  for (int row = 0; row < surface.extent.rows; row += 3) {
    for (int col = 0; col < surface.extent.cols; col += 3) {
      const int label = facets.label(row, col);
      if (label != pair.first && label != pair.second) continue;
      const double across = edge.normal.dot(surface.extent.place(row, col)) - edge.offset;
      const double near = std::exp(-std::abs(across) / (20.0 * pitch));
      side += (label == pair.second ? 1.0 : -1.0) * (across > 0.0 ? near : -near);
    }
  }
  if (side < 0.0) {
    edge.normal = -edge.normal;
    edge.offset = -edge.offset;
    extend();
  }
  const double reach = (facets.reach_px + 4) * pitch;
  edge.width = 0.5 * pitch;
  edge = fitted_edge(samples_near(surface, facets, candidate, reach), edge);
  extend();
  return candidate;
}

// The heights of the planes over the origin, from creases: both sides are equally high there.
std::vector<double> plane_heights(const Facets& facets,
                                  const std::vector<MeasuredCrease>& creases) {
  const int n = int(facets.facets.size());
  Eigen::MatrixXd matrix = 1e-9 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const MeasuredCrease& crease : creases) {
    const int a = crease.first, b = crease.second;
    for (const Vector2d& p : {crease.from, crease.to}) {
      const double gap =
          (facets.facets[std::size_t(a)].slope - facets.facets[std::size_t(b)].slope).dot(p);
      matrix(a, a) += 1.0, matrix(b, b) += 1.0, matrix(a, b) -= 1.0, matrix(b, a) -= 1.0;
      right[a] -= gap;
      right[b] += gap;
    }
  }
  const Eigen::VectorXd heights = matrix.ldlt().solve(right);
  return {heights.data(), heights.data() + n};
}

FoldFrame frame_of(const Surface& surface, const Facets& facets, const CreaseEnds& ends,
                   const std::vector<MeasuredCrease>& creases,
                   const std::vector<Vector2d>& outline) {
  FoldFrame frame;
  frame.unit = std::string(name_of(surface.extent.unit));
  frame.classes = {"foldedForm"};
  const auto heights = plane_heights(facets, creases);
  const auto lifted = [&](const Vector2d& p) {
    const Vector2d pixel = surface.extent.pixel(p);
    const int row = std::clamp(int(std::lround(pixel.x())), 0, facets.label.rows() - 1);
    const int col = std::clamp(int(std::lround(pixel.y())), 0, facets.label.cols() - 1);
    int label = facets.label(row, col);
    for (int r = 1; label < 0 && r < 12; ++r) {  // just outside the mask
      for (int k = 0; k < 8 && label < 0; ++k) {
        const int i = row + std::array{-r, -r, 0, r, r, r, 0, -r}[std::size_t(k)];
        const int j = col + std::array{0, r, r, r, 0, -r, -r, -r}[std::size_t(k)];
        if (facets.label.contains(i, j)) label = facets.label(i, j);
      }
    }
    const std::size_t f = std::size_t(std::max(label, 0));
    return Vector3d(p.x(), p.y(), facets.facets[f].slope.dot(p) + heights[f]);
  };
  for (const Vector2d& p : ends.places) frame.vertices.push_back(lifted(p));
  const auto add_edge = [&](int from, int to, Crease crease, double angle_deg) {
    if (from == to) return;
    frame.edges.push_back({from, to});
    frame.assignment.push_back(crease);
    frame.fold_angle_deg.push_back(angle_deg);
  };
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const double angle = creases[i].fold_angle / degree;
    add_edge(ends.of[i][0], ends.of[i][1], angle > 0.0 ? Crease::valley : Crease::mountain, angle);
  }
  const int first_corner = int(frame.vertices.size());
  for (const Vector2d& p : outline) frame.vertices.push_back(lifted(p));
  for (std::size_t k = 0; k < outline.size(); ++k) {
    std::vector<std::pair<double, int>> stops;
    for (std::size_t v = 0; v < ends.places.size(); ++v) {
      if (ends.side[v] == int(k)) stops.emplace_back((ends.places[v] - outline[k]).norm(), int(v));
    }
    std::sort(stops.begin(), stops.end());
    int last = first_corner + int(k);
    for (const auto& [distance, v] : stops) {
      add_edge(last, v, Crease::border, 0.0);
      last = v;
    }
    add_edge(last, first_corner + int((k + 1) % outline.size()), Crease::border, 0.0);
  }
  return frame;
}

std::vector<MeasuredVertex> inner_vertices(const CreaseEnds& ends,
                                           const std::vector<CreaseCandidate>& creases,
                                           const Facets& facets) {
  std::vector<MeasuredVertex> all;
  for (std::size_t v = 0; v < ends.places.size(); ++v) {
    if (ends.side[v] >= 0) continue;
    std::vector<ClosureWay> ways;
    for (std::size_t i = 0; i < creases.size(); ++i) {
      const auto [from, to] = ends.of[i];
      if (from != int(v) && to != int(v)) continue;
      const Facet &one = facets.facets[std::size_t(creases[i].first)],
                  &two = facets.facets[std::size_t(creases[i].second)];
      ways.push_back({ends.places[std::size_t(from == int(v) ? to : from)] - ends.places[v],
                      creases[i].edge.turn_sigma, one.slope, two.slope, one.sigma, two.sigma,
                      creases[i].first, creases[i].second});
    }
    if (ways.size() < 3) continue;
    const Closure closure = closure_of(ways);
    all.push_back({ends.places[v], int(ways.size()), closure.lack, closure.sigma});
  }
  return all;
}

// How well directions are known that all normals share: the median of what the surface says.
double shared_sigma(const Surface& surface) {
  if (surface.normal_sigma.empty()) return 0.0;
  std::vector<float> sigmas;
  for (std::size_t i = 0; i < surface.mask.size(); i += 7) {
    if (surface.mask[i]) sigmas.push_back(surface.normal_sigma[i]);
  }
  return sigmas.empty() ? 0.0 : double(median(std::move(sigmas)));
}

}  // namespace

MeasuredCreases measured_creases(const Surface& surface, const FacetOptions& options,
                                 const LightStack* stack) {
  Facets facets = facets_of(surface, options);
  MeasuredCreases result;
  LitFacets lit;
  if (stack) {
    lit = lit_facets(facets, surface, *stack);
    result.lights_turned = lit.turned;
    if (lit.dark_facet >= 0) stack = nullptr;  // planes stay as the surface has them
    for (std::size_t f = 0; f < lit.slopes.size(); ++f) {
      facets.facets[f].slope = lit.slopes[f];
      const Eigen::Index at = Eigen::Index(2 * f);
      facets.facets[f].sigma =
          std::sqrt(0.5 * (lit.covariance(at, at) + lit.covariance(at + 1, at + 1)));
    }
  }
  const double pitch = surface.extent.pitch;
  std::vector<CreaseCandidate> candidates;
  for (const auto& [pair, border] : borders(facets.label, surface.extent)) {
    if (int(border.size()) < 2 * facets.reach_px) continue;  // facets that touch at a corner
    candidates.push_back(candidate_of(surface, facets, pair, border));
  }
  const auto outline = outline_of(surface.mask, surface.extent);
  const CreaseEnds ends = ends_of(candidates, outline, 1.5 * facets.reach_px * pitch);
  const double shared = shared_sigma(surface);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const CreaseCandidate& c = candidates[i];
    const Facet &one = facets.facets[std::size_t(c.first)],
                &two = facets.facets[std::size_t(c.second)];
    MeasuredCrease crease;
    crease.first = c.first;
    crease.second = c.second;
    crease.from = ends.places[std::size_t(ends.of[i][0])];
    crease.to = ends.places[std::size_t(ends.of[i][1])];
    const double fold = fold_between(one.slope, two.slope);
    // Where the slope grows across the line the sheet opens to the viewer.
    crease.fold_angle = (two.slope - one.slope).dot(c.edge.normal) > 0.0 ? fold : -fold;
    // What facets scatter by themselves, and errors of light, which turn with the normal.
    crease.fold_angle_sigma =
        stack ? fold_sigma(lit, c.first, c.second)
              : std::hypot(std::hypot(one.sigma, two.sigma), shared * std::sin(fold));
    crease.offset_sigma = c.edge.offset_sigma;
    crease.width = c.edge.width;
    crease.width_sigma = c.edge.width_sigma;
    result.creases.push_back(crease);
  }
  result.frame = frame_of(surface, facets, ends, result.creases, outline);
  result.inner_vertices = inner_vertices(ends, candidates, facets);
  return result;
}

}  // namespace hada
