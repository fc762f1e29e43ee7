#include "fit/knit_stitch.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/parallel.h"
#include "synth/knit_loops.h"

namespace hada {
namespace {

constexpr int shape_fields = 6;  // radius and depth in wales, width, reach, two phases
using Shape = Eigen::Matrix<double, shape_fields, 1>;
const Shape lowest = (Shape() << 0.04, 0.0, 0.0, 0.4, -9.0, -99.0).finished();
const Shape highest = (Shape() << 0.35, 0.5, 0.3, 1.4, 9.0, 99.0).finished();

int wrapped_index(int k, int n) {
  return ((k % n) + n) % n;
}

/// The brightness that any light without shadows gives: 1, normal x, y, z, depth for each course,
/// and 1 in holes. A row for each place of the mean stitch.
using LightTerms = Eigen::MatrixXd;
constexpr int terms_of_yarn = 5;
constexpr double middle_slope = 0.75;  // of normal z, so that its term is none of brightness

/// The mean stitch as this problem sees it.
struct StitchProblem {
  const MeanStitch& mean;
  Knit<> knit;  // the lattice, its course distance that of one course
  int courses;
  int fine = 2;  // places of the rendering to one of the mean, each way

  int rows() const { return mean.weight.rows(); }
  int cols() const { return mean.weight.cols(); }

  Knit<> with(const Shape& shape) const {
    Knit<> now = knit;
    now.yarn_radius_mm = shape[0] * knit.wale_mm;
    now.loop_depth_mm = shape[1] * knit.wale_mm;
    now.loop_width = shape[2];
    now.loop_reach = shape[3];
    return now;
  }

  LightTerms terms(const Shape& shape) const {
    const Knit<> now = with(shape);
    const int fine_rows = fine * rows(), fine_cols = fine * cols();
    std::vector<YarnPoint> points;
    const auto curve = loop_curve(now);
    for (int j = 0; j < courses; ++j) {
      for (const auto& [wales, reach, z] : curve) {
        points.push_back({(courses - (j + reach + shape[5])) / courses * fine_rows - 0.5,
                          (wales + shape[4] + 0.5) * fine_cols - 0.5, z, j});
      }
    }
    const auto seen =
        seen_from_above(points, now.yarn_radius_mm, fine_rows, fine_cols,
                        {knit.wale_mm / fine_cols, courses * knit.course_mm / fine_rows}, true);
    LightTerms all = LightTerms::Zero(rows() * cols(), terms_of_yarn * courses + 1);
    const double part = 1.0 / (fine * fine);
    for (int row = 0; row < fine_rows; ++row) {
      for (int col = 0; col < fine_cols; ++col) {
        auto place = all.row((row / fine) * cols() + col / fine);
        const int course = seen.course(row, col);
        if (course < 0) {
          place[terms_of_yarn * courses] += part;
          continue;
        }
        const Eigen::Vector3d n = seen.normals(row, col).cast<double>();
        const int first = terms_of_yarn * course;
        place[first] += part;
        for (int k = 0; k < 3; ++k)
          place[first + 1 + k] += part * (k == 2 ? n[k] - middle_slope : n[k]);
        place[first + 4] += part * seen.height(row, col) / knit.wale_mm;
      }
    }
    return all;
  }

  /// Weighted residuals of the best light, all planes one after the other.
  struct Answer {
    Eigen::VectorXd residuals;
    Eigen::MatrixXd light;  // terms x planes
    double cost;
  };

  Answer answer(const Shape& shape) const {
    LightTerms all = terms(shape);
    Eigen::VectorXd root(all.rows());
    Eigen::MatrixXd values(all.rows(), Eigen::Index(mean.planes.size()));
    for (Eigen::Index k = 0; k < all.rows(); ++k) {
      root[k] = std::sqrt(double(mean.weight[std::size_t(k)]));
      for (std::size_t p = 0; p < mean.planes.size(); ++p) {
        values(k, Eigen::Index(p)) = root[k] * mean.planes[p][std::size_t(k)];
      }
    }
    all = root.asDiagonal() * all;
    Eigen::MatrixXd gram = all.transpose() * all;
    // Of two terms that look alike neither grows without end.
    gram.diagonal().array() += 1e-4 * gram.trace() / double(gram.rows());
    Answer found;
    found.light = gram.ldlt().solve(all.transpose() * values);
    const Eigen::MatrixXd left = values - all * found.light;
    found.residuals = left.reshaped();
    found.cost = found.residuals.squaredNorm();
    return found;
  }

  Eigen::MatrixXd jacobian(const Shape& shape) const {
    static const Shape step = (Shape() << 4e-3, 8e-3, 4e-3, 1e-2, 4e-3, 1e-2).finished();
    Eigen::MatrixXd slopes(rows() * cols() * Eigen::Index(mean.planes.size()), shape_fields);
    for (int k = 0; k < shape_fields; ++k) {
      Shape up = shape, down = shape;
      up[k] = std::min(highest[k], up[k] + step[k]);
      down[k] = std::max(lowest[k], down[k] - step[k]);
      slopes.col(k) = (answer(up).residuals - answer(down).residuals) / (up[k] - down[k]);
    }
    return slopes;
  }

  /// A few bounded steps of Levenberg and Marquardt.
  Shape descended(Shape shape, int rounds) const {
    Answer now = answer(shape);
    double damping = 1e-3;
    for (int round = 0; round < rounds; ++round) {
      const Eigen::MatrixXd slopes = jacobian(shape);
      const Eigen::MatrixXd matrix = slopes.transpose() * slopes;
      const Eigen::VectorXd pull = slopes.transpose() * now.residuals;
      bool better = false;
      for (int tries = 0; tries < 5 && !better; ++tries) {
        Eigen::MatrixXd damped = matrix;
        damped.diagonal() *= 1.0 + damping;
        damped.diagonal().array() += 1e-12 * matrix.trace();
        const Shape next =
            (shape - Shape(damped.ldlt().solve(pull))).cwiseMax(lowest).cwiseMin(highest);
        const Answer then = answer(next);
        better = then.cost < now.cost;
        if (better) {
          const double gain = (now.cost - then.cost) / now.cost;
          shape = next;
          now = then;
          damping = std::max(1e-6, damping * 0.2);
          if (gain < 1e-5) return shape;
        } else {
          damping *= 10.0;
        }
      }
      if (!better) break;
    }
    return shape;
  }
};

/// Where a search may start: thin and thick yarn, short and long loops, every phase.
std::vector<Shape> starts() {
  std::vector<Shape> all;
  for (const double radius : {0.12, 0.18}) {
    for (const double reach : {0.6, 0.85}) {
      for (const double wale : {0.0, 0.25, 0.5, 0.75}) {
        for (int course = 0; course < 4; ++course) {
          all.push_back((Shape() << radius, 0.14, 0.12, reach, wale, 0.25 * course).finished());
        }
      }
    }
  }
  return all;
}

/// Labels of courses by colour: courses closer than noise and unevenness allow share one.
std::vector<int> labels_of(const Eigen::MatrixXd& colours) {
  constexpr double alike = 0.12;  // of the mean brightness
  const Eigen::Index courses = colours.rows();
  const double scale = colours.cwiseAbs().mean();
  std::vector<int> label(std::size_t(courses), -1);
  std::vector<Eigen::Index> first;
  for (Eigen::Index j = 0; j < courses; ++j) {
    for (std::size_t k = 0; k < first.size() && label[std::size_t(j)] < 0; ++k) {
      const double apart =
          (colours.row(j) - colours.row(first[k])).norm() / std::sqrt(double(colours.cols()));
      if (apart < alike * scale) label[std::size_t(j)] = int(k);
    }
    if (label[std::size_t(j)] >= 0) continue;
    label[std::size_t(j)] = int(first.size());
    first.push_back(j);
  }
  return label;
}

/// Labels renamed so that darker yarns come first.
void sort_by_brightness(std::vector<int>& label, const Eigen::MatrixXd& colours) {
  const int count = 1 + *std::max_element(label.begin(), label.end());
  std::vector<double> brightness(std::size_t(count), 0.0);
  for (std::size_t j = label.size(); j-- > 0;) {
    brightness[std::size_t(label[j])] = colours.row(Eigen::Index(j)).mean();
  }
  std::vector<int> order(std::size_t(count), 0), name(std::size_t(count), 0);
  for (int k = 0; k < count; ++k) order[std::size_t(k)] = k;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return brightness[std::size_t(a)] < brightness[std::size_t(b)];
  });
  for (int k = 0; k < count; ++k) name[std::size_t(order[std::size_t(k)])] = k;
  for (int& value : label) value = name[std::size_t(value)];
}

int shortest_period(const std::vector<int>& label) {
  const int n = int(label.size());
  for (int period = 1; period < n; ++period) {
    if (n % period != 0) continue;
    bool same = true;
    for (int k = 0; k < n; ++k)
      same = same && label[std::size_t(k)] == label[std::size_t(k % period)];
    if (same) return period;
  }
  return n;
}

/// Colours, their repeat from course 0 (the one in the middle of the picture), and phases.
void set_colours(Knit<>& knit, const Eigen::MatrixXd& colours, const Shape& shape) {
  auto label = labels_of(colours);
  sort_by_brightness(label, colours);
  const int courses = int(label.size());
  const int yarns = 1 + *std::max_element(label.begin(), label.end());
  knit.yarns.assign(std::size_t(yarns), {0.0, 0.0, 0.0});
  std::vector<double> count(std::size_t(yarns), 0.0);
  for (int j = 0; j < courses; ++j) count[std::size_t(label[std::size_t(j)])] += 1.0;
  for (int j = 0; j < courses; ++j) {
    auto& yarn = knit.yarns[std::size_t(label[std::size_t(j)])];
    const double part = 1.0 / count[std::size_t(label[std::size_t(j)])];
    const auto at = [&](Eigen::Index c) {
      return std::clamp(colours(j, std::min(c, colours.cols() - 1)), 0.0, 4.0) * part;
    };
    yarn.red += at(0);
    yarn.green += at(1);
    yarn.blue += at(2);
  }
  // Row 0 of the mean lies a whole repeat above the origin of the lattice: course j is at j +
  // shape[5].
  const int middle = int(std::lround(-shape[5]));
  knit.course_phase = -shape[5] - middle;
  knit.wale_phase = double(std::lround(shape[4])) - shape[4];
  knit.colour_repeat.clear();
  const int period = shortest_period(label);
  for (int j = 0; j < period; ++j) {
    knit.colour_repeat.push_back(label[std::size_t(wrapped_index(middle + j, courses))]);
  }
}

}  // namespace

MeanStitch mean_stitch(const Surface& surface, const Knit<>& knit, int cols) {
  const int rows = std::max(8, int(std::lround(cols * knit.course_mm / knit.wale_mm)));
  MeanStitch mean;
  mean.weight = Grid<float>(rows, cols, 0.0f);
  mean.planes.assign(surface.albedo.planes.size(), Grid<float>(rows, cols, 0.0f));
  for (int row = 0; row < surface.extent.rows; ++row) {
    for (int col = 0; col < surface.extent.cols; ++col) {
      if (!surface.mask(row, col)) continue;
      const Eigen::Vector2d place = surface.extent.place(row, col);
      const auto [wale, course] = stitch_at(knit, place.x(), place.y());
      // The origin of the lattice lies in the middle of a row, and at the bottom of the repeat.
      const double across = wale + 0.5 - std::floor(wale + 0.5), up = course - std::floor(course);
      const int c = std::min(cols - 1, int(across * cols));
      const int r = std::min(rows - 1, int((1.0 - up) * rows));
      mean.weight(r, c) += 1.0f;
      for (std::size_t p = 0; p < mean.planes.size(); ++p) {
        mean.planes[p](r, c) += surface.albedo.planes[p](row, col);
      }
    }
  }
  for (auto& plane : mean.planes) {
    for (std::size_t k = 0; k < plane.size(); ++k) plane[k] /= std::max(1.0f, mean.weight[k]);
  }
  return mean;
}

StitchFit fit_stitch(const MeanStitch& mean, const Knit<>& knit, int courses) {
  StitchFit fit;
  fit.knit = knit;
  fit.knit.course_mm = knit.course_mm / courses;
  StitchProblem problem{mean, fit.knit, courses, 1};
  const auto from = starts();
  std::vector<double> costs(from.size());
  for_each_index(int(from.size()),
                 [&](int k) { costs[std::size_t(k)] = problem.answer(from[std::size_t(k)]).cost; });
  std::vector<std::size_t> order(from.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return costs[a] < costs[b]; });
  constexpr int promising = 4;
  std::vector<Shape> ends(promising);
  for_each_index(promising, [&](int k) {
    ends[std::size_t(k)] = problem.descended(from[order[std::size_t(k)]], 12);
  });
  Shape best = ends[0];
  for (const Shape& end : ends) {
    if (problem.answer(end).cost < problem.answer(best).cost) best = end;
  }
  problem.fine = 3;
  best = problem.descended(best, 12);
  const auto found = problem.answer(best);
  double variance = 0.0;
  for (const auto& plane : mean.planes) {
    double sum = 0.0, squares = 0.0, weight = 0.0;
    for (std::size_t k = 0; k < plane.size(); ++k) {
      sum += mean.weight[k] * plane[k];
      squares += mean.weight[k] * plane[k] * plane[k];
      weight += mean.weight[k];
    }
    variance += squares - sum * sum / weight;
  }
  fit.unexplained = found.cost / variance;
  fit.knit = problem.with(best);
  Eigen::MatrixXd colours(courses, found.light.cols());
  // As it is where the yarn comes nearest and looks up.
  const double crest = best[0] + best[1];
  for (int j = 0; j < courses; ++j) {
    const Eigen::MatrixXd light = found.light.middleRows(terms_of_yarn * j, terms_of_yarn);
    colours.row(j) = light.row(0) + (1.0 - middle_slope) * light.row(3) + crest * light.row(4);
  }
  set_colours(fit.knit, colours, best);

  // What is left of the mean is a misfit of the model more than noise: as many independent pieces
  // as there are stretches of a yarn's width along the loop, and no more for more repeats.
  const Eigen::MatrixXd slopes = problem.jacobian(best);
  const double pieces = 4.0 * courses / best[0];
  const double per_piece = found.residuals.squaredNorm() / std::max(1.0, pieces - shape_fields);
  Eigen::MatrixXd information = slopes.transpose() * slopes;
  information.diagonal().array() += 1e-12 * information.trace();
  const Shape sigma = (information.inverse().diagonal() * per_piece).cwiseSqrt();
  fit.sigma = sigma;
  double weight = 0.0;
  for (const float count : mean.weight) weight += count;
  fit.colour_sigma = std::sqrt(found.cost / (weight * double(mean.planes.size())));
  fit.sigma[0] *= knit.wale_mm;
  fit.sigma[1] *= knit.wale_mm;
  fit.on_bound = ((best - lowest).array() <= 0.0).any() || ((highest - best).array() <= 0.0).any();
  return fit;
}

}  // namespace hada
