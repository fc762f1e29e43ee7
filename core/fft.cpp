#include "core/fft.h"

#include <algorithm>
#include <span>

#include <opencv2/core.hpp>

#include "core/parallel.h"

namespace hada {
namespace {

// Rows that lie 2^k bytes apart fall into few places of a cache: columns are transformed some at a
// time, as rows of a piece of memory that fits into it.
constexpr int columns_at_once = 8;
constexpr int rows_at_once = 64;

/// A matrix over values that are there. OpenCV has no read-only one; its sources are only read.
template <class T>
cv::Mat view(const T* values, int rows, int cols) {
  return cv::Mat(rows, cols, cv::traits::Type<T>::value, const_cast<T*>(values));
}

template <class T>
cv::Mat view(const std::complex<T>* values, int rows, int cols) {
  return view(reinterpret_cast<const cv::Vec<T, 2>*>(values), rows, cols);
}

/// Calls work(first, count) on all of [0, total), so many at once.
template <class Work>
void for_pieces(int total, int at_once, const Work& work) {
  for_each_index((total + at_once - 1) / at_once, [&](int piece) {
    const int first = piece * at_once;
    work(first, std::min(at_once, total - first));
  });
}

/// Transforms the columns in their places; prepare(column of the grid, its values).
template <class T, class Prepare>
void transform_columns(Grid<std::complex<T>>& half, int flags, const Prepare& prepare) {
  const int rows = half.rows();
  for_pieces(half.cols(), columns_at_once, [&](int first, int count) {
    Grid<std::complex<T>> columns(count, rows);
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k < count; ++k) columns(k, row) = half(row, first + k);
    }
    for (int k = 0; k < count; ++k) prepare(first + k, columns.row(k));
    cv::Mat lines = view(columns.data(), count, rows);
    cv::dft(lines, lines, flags | cv::DFT_ROWS);
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k < count; ++k) half(row, first + k) = columns(k, row);
    }
  });
}

}  // namespace

// OpenCV's transform of a real row has its real and imaginary parts side by side, but those that
// are 0: of the first column and, for even cols, of the last.
template <class T>
Grid<std::complex<T>> fft(const Grid<T>& real) {
  const int rows = real.rows(), cols = real.cols();
  Grid<std::complex<T>> half(rows, cols / 2 + 1);
  for_pieces(rows, rows_at_once, [&](int first, int count) {
    Grid<T> packed(count, cols);
    cv::dft(view(real.row(first).data(), count, cols), view(packed.data(), count, cols),
            cv::DFT_ROWS);
    for (int k = 0; k < count; ++k) {
      const auto source = packed.row(k);
      const auto target = half.row(first + k);
      target[0] = source[0];
      for (std::size_t col = 1; 2 * col < source.size(); ++col)
        target[col] = {source[2 * col - 1], source[2 * col]};
      if (cols % 2 == 0) target[target.size() - 1] = source[source.size() - 1];
    }
  });
  transform_columns(half, 0, [](int, auto) {});
  return half;
}

template <class T>
Grid<T> inverse_fft(Grid<std::complex<T>> half, int cols) {
  assert(half.cols() == cols / 2 + 1);
  const int rows = half.rows();
  const auto mirrored = [&](int col, std::span<std::complex<T>> values) {
    if (col != 0 && 2 * col != cols) return;
    // Its own mirror image: what lies below the middle is not read.
    for (int row = 0; 2 * row <= rows; ++row) {
      const int other = (rows - row) % rows;
      values[std::size_t(other)] = other == row ? std::complex<T>(values[std::size_t(row)].real())
                                                : std::conj(values[std::size_t(row)]);
    }
  };
  transform_columns(half, cv::DFT_INVERSE | cv::DFT_SCALE, mirrored);
  Grid<T> real(rows, cols);
  for_pieces(rows, rows_at_once, [&](int first, int count) {
    for (int k = 0; k < count; ++k) {
      const auto source = half.row(first + k);
      const auto target = real.row(first + k);
      target[0] = source[0].real();
      for (std::size_t col = 1; 2 * col < target.size(); ++col) {
        target[2 * col - 1] = source[col].real();
        target[2 * col] = source[col].imag();
      }
      if (cols % 2 == 0) target[target.size() - 1] = source[source.size() - 1].real();
    }
    cv::Mat lines = view(real.row(first).data(), count, cols);
    cv::dft(lines, lines, cv::DFT_INVERSE | cv::DFT_ROWS | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  });
  return real;
}

int fast_length(int least) {
  for (int length = std::max(least, 1);; ++length) {
    int rest = length;
    for (const int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return length;
  }
}

template Grid<std::complex<float>> fft(const Grid<float>&);
template Grid<std::complex<double>> fft(const Grid<double>&);
template Grid<float> inverse_fft(Grid<std::complex<float>>, int);
template Grid<double> inverse_fft(Grid<std::complex<double>>, int);

}  // namespace hada
