#include "fit/knit_refine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "core/parallel.h"
#include "measure/line_field.h"

namespace hada {
namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

constexpr int fine = 2;                // places that are drawn to a pixel, each way
constexpr int terms_of_yarn = 5;       // 1, normal x, y, z, depth
constexpr double longest_step = 0.25;  // in stitches

/// Where a pixel lies among the crossings; no crossing where it shows something else.
struct InKnit {
  float wale = 0.0f, course = 0.0f;
  bool inside = false;
};

/// The (u, v) in the unit square whose bilinear place in a cell is `place`; may lie outside.
Vector2d in_cell(const std::array<Vector2d, 4>& corner, const Vector2d& place) {
  const Vector2d a = corner[1] - corner[0], b = corner[2] - corner[0];
  const Vector2d twist = corner[3] - corner[1] - b;
  Vector2d at(0.5, 0.5);
  for (int round = 0; round < 5; ++round) {
    Matrix2d slopes;
    slopes << a + at.y() * twist, b + at.x() * twist;
    const Vector2d off = corner[0] + at.x() * a + at.y() * b + at.x() * at.y() * twist - place;
    at -= slopes.inverse() * off;
  }
  return at;
}

/// Every pixel that the piece, and a stitch around it, covers.
Grid<InKnit> places_in_knit(const BentKnit& bent, const Extent& extent) {
  Grid<InKnit> all(extent.rows, extent.cols);
  for (int j = -1; j < bent.courses; ++j) {
    for (int i = -1; i < bent.wales; ++i) {
      const std::array<Vector2d, 4> corner{bent.at(i, j), bent.at(i + 1, j), bent.at(i, j + 1),
                                           bent.at(i + 1, j + 1)};
      Eigen::Array2d low = extent.pixel(corner[0]).array(), high = low;
      for (const auto& c : corner) {
        low = low.min(extent.pixel(c).array()), high = high.max(extent.pixel(c).array());
      }
      for (int row = std::max(0, int(low[0])); row <= std::min(extent.rows - 1, int(high[0]) + 1);
           ++row) {
        for (int col = std::max(0, int(low[1])); col <= std::min(extent.cols - 1, int(high[1]) + 1);
             ++col) {
          const Vector2d at = in_cell(corner, extent.place(row, col));
          if (!(at.minCoeff() >= 0.0 && at.maxCoeff() <= 1.0)) continue;
          all(row, col) = {float(i + at.x()), float(j + at.y()), true};
        }
      }
    }
  }
  return all;
}

/// The terms that brightness is linear in, a row for each pixel: five of each yarn, and the ground.
using Terms = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Terms drawn(const Knit<>& knit, const BentKnit& bent, const Extent& extent) {
  const Extent finer{fine * extent.rows, fine * extent.cols, extent.pitch / fine, extent.unit};
  const auto maps =
      seen_from_above(bent_loops(knit, bent, finer, &BentKnit::smooth), knit.yarn_radius_mm,
                      finer.rows, finer.cols, {finer.pitch, finer.pitch}, false);
  const int yarns = int(knit.yarns.size());
  const double part = 1.0 / (fine * fine);
  Terms terms = Terms::Zero(extent.rows * extent.cols, terms_of_yarn * yarns + 1);
  for_each_index(extent.rows, [&](int row) {
    for (int col = 0; col < extent.cols; ++col) {
      auto here = terms.row(row * extent.cols + col);
      for (int k = 0; k < fine * fine; ++k) {
        const int r = fine * row + k / fine, c = fine * col + k % fine;
        const int stitch = maps.course(r, c);
        if (stitch < 0) {
          here[terms_of_yarn * yarns] += part;
          continue;
        }
        const auto course = std::size_t(stitch / bent.wales) % knit.colour_repeat.size();
        const int first =
            terms_of_yarn * std::clamp(int(knit.colour_repeat[course] + 0.5), 0, yarns - 1);
        const auto& n = maps.normals(r, c);
        here[first] += part;
        for (int axis = 0; axis < 3; ++axis) here[first + 1 + axis] += part * double(n[axis]);
        here[first + 4] += part * maps.height(r, c) / knit.wale_mm;
      }
    }
  });
  return terms;
}

/// A drawn photograph: what the terms explain of each plane, in the best light.
std::vector<Grid<float>> lit(const Terms& terms, const Grid<InKnit>& in_knit,
                             const Image& photograph) {
  Terms gram = Terms::Zero(terms.cols(), terms.cols());
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(terms.cols(), photograph.channels());
  for (std::size_t k = 0; k < in_knit.size(); ++k) {
    if (!in_knit[k].inside) continue;
    const auto row = terms.row(Eigen::Index(k));
    gram.noalias() += row.transpose() * row;
    for (int p = 0; p < photograph.channels(); ++p) {
      right.col(p) += double(photograph.planes[std::size_t(p)][k]) * row.transpose();
    }
  }
  gram.diagonal().array() += 1e-6 * gram.trace() / double(gram.rows());
  const Eigen::MatrixXd light = Eigen::MatrixXd(gram).ldlt().solve(right);
  std::vector<Grid<float>> planes;
  for (int p = 0; p < photograph.channels(); ++p) {
    Grid<float> plane(in_knit.rows(), in_knit.cols());
    for (std::size_t k = 0; k < plane.size(); ++k) {
      plane[k] = float(terms.row(Eigen::Index(k)) * light.col(p));
    }
    planes.push_back(std::move(plane));
  }
  return planes;
}

/// The crossings around a place and the bilinear share that each has in it; beyond the border it is
/// that of the outermost cell, drawn on.
struct Shares {
  std::array<int, 4> crossing;
  std::array<double, 4> share;
};

Shares shares_of(const BentKnit& bent, const InKnit& at) {
  const int i = std::clamp(int(at.wale), 0, bent.wales - 2);
  const int j = std::clamp(int(at.course), 0, bent.courses - 2);
  const double u = at.wale - i, v = at.course - j;
  const int k = j * bent.wales + i;
  return {{k, k + 1, k + bent.wales, k + bent.wales + 1},
          {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v}};
}

/// The normal equations of all steps, in the unit of the picture.
struct Normal {
  std::vector<std::array<Matrix2d, 9>> blocks;  // of a crossing with those around it, itself at 4
  std::vector<Vector2d> right;
};

Normal normal_equations(const BentKnit& bent, const Grid<InKnit>& in_knit, const Extent& extent,
                        const std::vector<Grid<float>>& prediction,
                        const std::vector<Grid<float>>& photograph) {
  const auto count = bent.places.size();
  std::array<Matrix2d, 9> none;
  none.fill(Matrix2d::Zero());
  Normal normal{std::vector(count, none), std::vector<Vector2d>(count, Vector2d::Zero())};
  const double scale = 0.5 / extent.pitch;
  for (int row = 1; row + 1 < extent.rows; ++row) {
    for (int col = 1; col + 1 < extent.cols; ++col) {
      const InKnit& at = in_knit(row, col);
      if (!at.inside) continue;
      Matrix2d square = Matrix2d::Zero();
      Vector2d pull = Vector2d::Zero();
      for (std::size_t p = 0; p < prediction.size(); ++p) {
        const auto& g = prediction[p];
        const Vector2d slope(scale * double(g(row, col + 1) - g(row, col - 1)),
                             scale * double(g(row - 1, col) - g(row + 1, col)));
        square += slope * slope.transpose();
        // What moves by d shows at a place what was there at -d.
        pull -= double(photograph[p](row, col) - g(row, col)) * slope;
      }
      const Shares s = shares_of(bent, at);
      for (std::size_t a = 0; a < 4; ++a) {
        normal.right[std::size_t(s.crossing[a])] += s.share[a] * pull;
        for (std::size_t b = 0; b < 4; ++b) {
          const int right = int(b % 2) - int(a % 2), up = int(b / 2) - int(a / 2);
          normal.blocks[std::size_t(s.crossing[a])][std::size_t(4 + right + 3 * up)] +=
              s.share[a] * s.share[b] * square;
        }
      }
    }
  }
  return normal;
}

std::vector<Vector2d> solved(const Normal& normal, int wales) {
  constexpr double held = 1e-3;  // of the mean: what shows nothing stays
  const int count = int(normal.right.size());
  double mean = 0.0;
  for (const auto& blocks : normal.blocks) mean += 0.5 * blocks[4].trace() / count;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(2 * count);
  for (int k = 0; k < count; ++k) {
    right.segment<2>(2 * k) = normal.right[std::size_t(k)];
    for (int n = 0; n < 9; ++n) {
      const int other = k + n % 3 - 1 + (n / 3 - 1) * wales;
      const Matrix2d& block = normal.blocks[std::size_t(k)][std::size_t(n)];
      if (other < 0 || other >= count || block.isZero(0.0)) continue;
      for (int r = 0; r < 2; ++r) {
        for (int c = 0; c < 2; ++c) {
          const double extra = n == 4 && r == c ? held * mean : 0.0;
          entries.emplace_back(2 * k + r, 2 * other + c, block(r, c) + extra);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(2 * count, 2 * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd steps =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  std::vector<Vector2d> all;
  for (int k = 0; k < count; ++k) all.emplace_back(steps.segment<2>(2 * k));
  return all;
}

std::vector<Grid<float>> smoothed_planes(const std::vector<Grid<float>>& planes, double sigma_px) {
  if (sigma_px <= 0.0) return planes;
  std::vector<Grid<float>> smooth;
  const Mask all(planes[0].rows(), planes[0].cols(), 1);
  for (const auto& plane : planes) smooth.push_back(smoothed(plane, all, sigma_px));
  return smooth;
}

double stitch_of(const BentKnit& bent, int k) {
  const int i = k % bent.wales, j = k / bent.wales;
  return 0.5 * std::min((bent.at(i + 1, j) - bent.at(i - 1, j)).norm(),
                        (bent.at(i, j + 1) - bent.at(i, j - 1)).norm());
}

/// Correlation of the drawn picture with the photograph over each crossing's own stitch.
std::vector<double> likeness_of(const BentKnit& bent, const Grid<InKnit>& in_knit,
                                const std::vector<Grid<float>>& prediction,
                                const std::vector<Grid<float>>& photograph) {
  struct Sums {
    double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  };
  const auto count = bent.places.size();
  std::vector<Sums> sums(count * prediction.size());
  for (std::size_t k = 0; k < in_knit.size(); ++k) {
    const int i = int(std::lround(in_knit[k].wale)), j = int(std::lround(in_knit[k].course));
    if (!in_knit[k].inside || i < 0 || j < 0 || i >= bent.wales || j >= bent.courses) continue;
    for (std::size_t p = 0; p < prediction.size(); ++p) {
      Sums& s = sums[p * count + std::size_t(j * bent.wales + i)];
      const double a = prediction[p][k], b = photograph[p][k];
      s.n += 1.0, s.a += a, s.b += b, s.aa += a * a, s.bb += b * b, s.ab += a * b;
    }
  }
  std::vector<double> likeness(count, 0.0);
  for (std::size_t c = 0; c < count; ++c) {
    double both = 0.0, one = 0.0, other = 0.0;
    for (std::size_t p = 0; p < prediction.size(); ++p) {
      const Sums& s = sums[p * count + c];
      if (s.n == 0.0) continue;
      both += s.ab - s.a * s.b / s.n, one += s.aa - s.a * s.a / s.n,
          other += s.bb - s.b * s.b / s.n;
    }
    likeness[c] = both / std::sqrt(std::max(one * other, 1e-30));
  }
  return likeness;
}

}  // namespace

RefinedCrossings refined(const Surface& picture, const Knit<>& knit, const BentKnit& start) {
  constexpr int most_rounds = 15;
  // Drawn edges fall on whole places: steps end at a fiftieth of a pixel or so.
  constexpr double still_px = 0.02, slower = 0.9;
  BentKnit bent = start;
  RefinedCrossings found;
  const double stitch_px = std::min(knit.wale_mm, knit.course_mm) / picture.extent.pitch;
  std::vector<double> likeness;
  for (const double smooth_px : {0.12 * stitch_px, 0.0}) {
    const auto photograph = smoothed_planes(picture.albedo.planes, smooth_px);
    for (int round = 0; round < most_rounds; ++round) {
      const auto in_knit = places_in_knit(bent, picture.extent);
      const auto prediction = smoothed_planes(
          lit(drawn(knit, bent, picture.extent), in_knit, picture.albedo), smooth_px);
      found.likeness = likeness_of(bent, in_knit, prediction, photograph);
      const auto steps = solved(
          normal_equations(bent, in_knit, picture.extent, prediction, photograph), bent.wales);
      double sum = 0.0;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const double most = longest_step * stitch_of(bent, int(k));
        const Vector2d step = steps[k] * std::min(1.0, most / std::max(steps[k].norm(), 1e-300));
        bent.places[k].head<2>() += step;
        sum += step.squaredNorm();
      }
      const double step_px = std::sqrt(sum / double(steps.size())) / picture.extent.pitch;
      const bool done = step_px < still_px || (round > 2 && step_px > slower * found.last_step_px);
      found.last_step_px = step_px;
      if (done) break;
    }
  }
  found.places = bent.places;
  return found;
}

}  // namespace hada
