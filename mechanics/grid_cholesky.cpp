#include "mechanics/grid_cholesky.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int leaf = 5;  // parts whose sides are no longer are not halved

}  // namespace

GridMatrix::GridMatrix(int rows_, int cols_, bool round_, int block_)
    : rows(rows_), cols(cols_), round(round_), block(block_) {
  own = right = up = Eigen::MatrixXd::Zero(block, block * rows * cols);
}

GridCholesky::GridCholesky(int rows, int cols, bool round)
    : rows_(rows), cols_(cols), round_(round) {
  dissect({0, rows, 0, cols}, 0);
}

int GridCholesky::dissect(const Part& part, int depth) {
  Front front;
  const bool whole_ring = round_ && part.cols == cols_;
  const auto add = [&](int row, int col) {
    if (row < 0 || row >= rows_) return;
    if (round_) col = (col + cols_) % cols_;
    if (col < 0 || col >= cols_) return;
    const int point = row * cols_ + col;
    const auto& known = front.points;
    if (std::find(known.begin(), known.end(), point) == known.end()) front.points.push_back(point);
  };
  const auto add_part = [&](const Part& p) {
    for (int row = p.row; row < p.row + p.rows; ++row) {
      for (int col = p.col; col < p.col + p.cols; ++col) {
        front.points.push_back(row * cols_ + col);
      }
    }
  };
  const auto halves = [&](const Part& first, const Part& second) {
    for (const Part& half : {first, second}) {
      if (half.rows > 0 && half.cols > 0) front.children.push_back(dissect(half, depth + 1));
    }
  };
  if (part.rows <= leaf && part.cols <= leaf) {
    add_part(part);
  } else if (whole_ring) {
    add_part({part.row, part.rows, part.col, 1});
    halves({part.row, part.rows, part.col + 1, part.cols - 1}, {});
  } else if (part.cols >= part.rows) {
    const int middle = part.col + part.cols / 2;
    add_part({part.row, part.rows, middle, 1});
    halves({part.row, part.rows, part.col, middle - part.col},
           {part.row, part.rows, middle + 1, part.col + part.cols - middle - 1});
  } else {
    const int middle = part.row + part.rows / 2;
    add_part({middle, 1, part.col, part.cols});
    halves({part.row, middle - part.row, part.col, part.cols},
           {middle + 1, part.row + part.rows - middle - 1, part.col, part.cols});
  }
  front.eliminated = int(front.points.size());
  // The frame around the part: all that it touches is eliminated later.
  for (int col = part.col; col < part.col + part.cols; ++col) {
    add(part.row - 1, col), add(part.row + part.rows, col);
  }
  for (int row = part.row; row < part.row + part.rows && !whole_ring; ++row) {
    add(row, part.col - 1), add(row, part.col + part.cols);
  }
  fronts_.push_back(std::move(front));
  if (int(levels_.size()) <= depth) levels_.resize(std::size_t(depth) + 1);
  levels_[std::size_t(depth)].push_back(int(fronts_.size()) - 1);
  return int(fronts_.size()) - 1;
}

void GridCholesky::eliminate(Front& front, const GridMatrix& matrix) const {
  const int b = block_, size = b * int(front.points.size()), out = b * front.eliminated;
  std::vector<std::pair<int, int>> places;  // point and its place in the front, for searching
  for (int i = 0; i < int(front.points.size()); ++i) {
    places.emplace_back(front.points[std::size_t(i)], i);
  }
  std::sort(places.begin(), places.end());
  const auto place = [&](int point) {
    const auto found = std::lower_bound(places.begin(), places.end(), std::pair{point, 0});
    return found != places.end() && found->first == point ? found->second : -1;
  };
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(size, size);  // its lower half counts
  const auto couple = [&](int a, int other, const Eigen::MatrixXd& blocks, int at, bool turned) {
    const int c = place(other);
    if (c < a) return;  // absent, or eliminated before and entered then
    const auto value = blocks.middleCols(b * at, b);
    auto target = full.block(b * c, b * a, b, b);
    if (turned) {
      target += value;
    } else {
      target += value.transpose();
    }
  };
  for (int a = 0; a < front.eliminated; ++a) {
    const int point = front.points[std::size_t(a)], col = point % cols_;
    full.block(b * a, b * a, b, b) += matrix.own.middleCols(b * point, b);
    if (col + 1 < cols_ || round_) {
      couple(a, point - col + (col + 1) % cols_, matrix.right, point, false);
    }
    if (col > 0 || round_) {
      const int left = point - col + (col + cols_ - 1) % cols_;
      couple(a, left, matrix.right, left, true);
    }
    if (point + cols_ < rows_ * cols_) couple(a, point + cols_, matrix.up, point, false);
    if (point >= cols_) couple(a, point - cols_, matrix.up, point - cols_, true);
  }
  for (const int child_index : front.children) {
    const Front& child = fronts_[std::size_t(child_index)];
    const int others = int(child.points.size()) - child.eliminated;
    std::vector<int> to(static_cast<std::size_t>(others));
    for (int i = 0; i < others; ++i) {
      to[std::size_t(i)] = b * place(child.points[std::size_t(child.eliminated + i)]);
    }
    for (int j = 0; j < others; ++j) {
      for (int i = j; i < others; ++i) {
        const int row = to[std::size_t(i)], column = to[std::size_t(j)];
        const auto value = child.rest.block(b * i, b * j, b, b);
        if (row >= column) {
          full.block(row, column, b, b) += value;
        } else {
          full.block(column, row, b, b) += value.transpose();
        }
      }
    }
  }
  Eigen::Ref<Eigen::MatrixXd> corner(full.topLeftCorner(out, out));
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(corner);  // in place
  if (factor.info() != Eigen::Success) {
    throw Error("the stiffness of the grid is not positive definite: it can move without force");
  }
  auto below = full.bottomLeftCorner(size - out, out);
  corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
  front.rest = full.bottomRightCorner(size - out, size - out);
  front.rest.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  front.lower = full.leftCols(out);
}

void GridCholesky::factorize(const GridMatrix& matrix) {
  block_ = matrix.block;
  for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
    for_each_index(int(level->size()), [&](int i) {
      Front& front = fronts_[std::size_t((*level)[std::size_t(i)])];
      eliminate(front, matrix);
      for (const int child : front.children) fronts_[std::size_t(child)].rest.resize(0, 0);
    });
  }
}

Eigen::VectorXd GridCholesky::solve(const Eigen::VectorXd& right_side) const {
  const int b = block_;
  Eigen::VectorXd x = right_side;
  const auto part = [&](const Front& front, int begin, int end) {
    Eigen::VectorXd values(b * (end - begin));
    for (int i = begin; i < end; ++i) {
      values.segment(b * (i - begin), b) = x.segment(b * front.points[std::size_t(i)], b);
    }
    return values;
  };
  const auto put = [&](const Front& front, const Eigen::VectorXd& values) {
    for (int i = 0; i < front.eliminated; ++i) {
      x.segment(b * front.points[std::size_t(i)], b) = values.segment(b * i, b);
    }
  };
  for (const Front& front : fronts_) {
    const int count = int(front.points.size()), out = b * front.eliminated;
    Eigen::VectorXd own = part(front, 0, front.eliminated);
    front.lower.topRows(out).triangularView<Eigen::Lower>().solveInPlace(own);
    put(front, own);
    const Eigen::VectorXd others = front.lower.bottomRows(b * count - out) * own;
    for (int i = front.eliminated; i < count; ++i) {
      x.segment(b * front.points[std::size_t(i)], b) -=
          others.segment(b * (i - front.eliminated), b);
    }
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const int count = int(front->points.size()), out = b * front->eliminated;
    Eigen::VectorXd own = part(*front, 0, front->eliminated);
    own -= front->lower.bottomRows(b * count - out).transpose() *
           part(*front, front->eliminated, count);
    front->lower.topRows(out).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    put(*front, own);
  }
  return x;
}

}  // namespace hada
