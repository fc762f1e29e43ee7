#include "reconstruct/level.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include <Eigen/Dense>

#include "core/parallel.h"

namespace hada {
namespace {

using Terms = Eigen::Matrix<double, 6, 1>;
using Products = Eigen::Matrix<double, 6, 6>;

int terms_of(Levelling levelling) {
  switch (levelling) {
    case Levelling::offset:
      return 1;
    case Levelling::plane:
      return 3;
    case Levelling::quadratic:
      return 6;
  }
  return 1;
}

// 1, x, y, x^2, x y, y^2 at a pixel, with the longer side of the grid from -1 to 1; the terms that
// are not asked for are 0.
class Basis {
 public:
  Basis(const Grid<float>& height, Levelling levelling)
      : terms_(terms_of(levelling)),
        middle_row_(0.5 * (height.rows() - 1)),
        middle_col_(0.5 * (height.cols() - 1)),
        scale_(2.0 / std::max({height.rows(), height.cols(), 2})) {}

  Terms at(int row, int col) const {
    const double x = (col - middle_col_) * scale_;
    const double y = (middle_row_ - row) * scale_;
    Terms terms;
    terms << 1.0, x, y, x * x, x * y, y * y;
    terms.tail(6 - terms_).setZero();
    return terms;
  }

 private:
  int terms_;
  double middle_row_;
  double middle_col_;
  double scale_;
};

struct NormalEquations {
  Products products = Products::Zero();
  Terms right = Terms::Zero();
};

}  // namespace

std::string_view name_of(Levelling levelling) {
  switch (levelling) {
    case Levelling::offset:
      return "offset";
    case Levelling::plane:
      return "plane";
    case Levelling::quadratic:
      return "quadratic";
  }
  return "offset";
}

void level(Grid<float>& height, const Mask& mask, Levelling levelling) {
  assert(height.same_size(mask));
  const Basis basis(height, levelling);
  std::vector<NormalEquations> rows(std::size_t(height.rows()));
  for_each_index(height.rows(), [&](int row) {
    NormalEquations& sum = rows[std::size_t(row)];
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Terms terms = basis.at(row, col);
      sum.products.noalias() += terms * terms.transpose();
      sum.right += double(height(row, col)) * terms;
    }
  });
  NormalEquations total;
  for (const NormalEquations& row : rows) {
    total.products += row.products;
    total.right += row.right;
  }
  // The smallest of all solutions: a mask that is a single line says nothing of the tilt across it.
  const Terms removed = total.products.completeOrthogonalDecomposition().solve(total.right);
  for_each_index(height.rows(), [&](int row) {
    for (int col = 0; col < height.cols(); ++col) {
      height(row, col) =
          mask(row, col) ? float(height(row, col) - removed.dot(basis.at(row, col))) : 0.0f;
    }
  });
}

}  // namespace hada
