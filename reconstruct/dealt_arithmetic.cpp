#include "reconstruct/dealt_arithmetic.h"

#include "core/parallel.h"
#include "reconstruct/row_arithmetic.h"
#include "reconstruct/sum_of_rows.h"

namespace hada {

double dot(const Dealt& at, const Cells& a, const Cells& b) {
  return sum_of_rows(at.rows, [&](int row) {
    const auto first = at.start(row, 0);
    return row_kernels::dot(int(at.stride()), a.data() + first, b.data() + first);
  });
}

void add_times(const Dealt& at, double factor, const Cells& x, Cells& total) {
  for_each_index(at.rows, [&](int row) {
    const auto first = at.start(row, 0);
    row_kernels::add_times(int(at.stride()), float(factor), x.data() + first, total.data() + first);
  });
}

void add_times(const Dealt& at, double factor, const Cells& x, Grid<float>& total) {
  for_each_index(at.rows, [&](int row) {
    row_kernels::add_gathered(at.cols, float(factor), x.data() + at.start(row, 0),
                              x.data() + at.start(row, 1), total.row(row).data());
  });
}

void undeal(const Dealt& at, Grid<float>& values) {
  // In order: a row never comes to lie where one is that is still to be moved.
  float* const data = values.data();
  for (int row = 0; row < at.rows; ++row) {
    row_kernels::gather(at.cols, data + at.start(row, 0), data + at.start(row, 1),
                        data + std::ptrdiff_t(row) * at.cols);
  }
  values.shrink_to(at.rows, at.cols);
}

}  // namespace hada
