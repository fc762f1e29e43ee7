#include "core/fft.h"

#include <opencv2/core.hpp>

namespace hada {
namespace {

template <class T>
cv::Mat view(const Grid<T>& grid) {
  // OpenCV has no read-only matrix; the transforms below only read their source.
  return cv::Mat(grid.rows(), grid.cols(), cv::traits::Type<T>::value, const_cast<T*>(grid.data()));
}

template <class T>
using complex_scalar = cv::Vec<T, 2>;

}  // namespace

template <class T>
Grid<std::complex<T>> fft(const Grid<T>& real) {
  const int rows = real.rows();
  const int half_cols = real.cols() / 2 + 1;
  cv::Mat full;
  cv::dft(view(real), full, cv::DFT_COMPLEX_OUTPUT);
  Grid<std::complex<T>> half(rows, half_cols);
  for (int row = 0; row < rows; ++row) {
    const auto* source = full.ptr<complex_scalar<T>>(row);
    for (int col = 0; col < half_cols; ++col) half(row, col) = {source[col][0], source[col][1]};
  }
  return half;
}

template <class T>
Grid<T> inverse_fft(const Grid<std::complex<T>>& half, int cols) {
  assert(half.cols() == cols / 2 + 1);
  const int rows = half.rows();
  // OpenCV's packed layout (CCS) of the transform of a real matrix: real and imaginary parts of the
  // columns 1 .. side by side, the self-conjugate first (and, for even cols, last) column folded.
  Grid<T> real(rows, cols);
  cv::Mat packed = view(real);
  const auto fold_column = [&](int column_of_half, int column) {
    const auto at = [&](int row) -> std::complex<T> { return half(row, column_of_half); };
    packed.at<T>(0, column) = at(0).real();
    for (int row = 1; 2 * row < rows; ++row) {
      packed.at<T>(2 * row - 1, column) = at(row).real();
      packed.at<T>(2 * row, column) = at(row).imag();
    }
    if (rows % 2 == 0) packed.at<T>(rows - 1, column) = at(rows / 2).real();
  };
  fold_column(0, 0);
  if (cols % 2 == 0) fold_column(cols / 2, cols - 1);
  for (int row = 0; row < rows; ++row) {
    T* target = packed.ptr<T>(row);
    for (int col = 1; 2 * col < cols; ++col) {
      target[2 * col - 1] = half(row, col).real();
      target[2 * col] = half(row, col).imag();
    }
  }
  cv::idft(packed, packed, cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);  // in its own place
  assert(packed.ptr<T>() == real.data());
  return real;
}

template Grid<std::complex<float>> fft(const Grid<float>&);
template Grid<std::complex<double>> fft(const Grid<double>&);
template Grid<float> inverse_fft(const Grid<std::complex<float>>&, int);
template Grid<double> inverse_fft(const Grid<std::complex<double>>&, int);

}  // namespace hada
