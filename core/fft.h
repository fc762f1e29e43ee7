#pragma once

#include <complex>

#include "core/grid.h"

namespace hada {

/// Half of the discrete Fourier transform of a real grid: cols / 2 + 1 columns, frequency (i, j) at
/// row i modulo rows and column j; the other half is its conjugate mirror image.
///
/// F(i, j) = sum over row, col of f(row, col) exp(-2 pi i (i row / rows + j col / cols)), no
/// factor. T is float or double.
template <class T>
Grid<std::complex<T>> fft(const Grid<T>& real);

/// The real grid with `cols` columns whose transform is `half`: inverse of `fft`, factor 1 / size.
/// Of columns that are their own mirror image, the first and for even `cols` the last, only the
/// rows up to the middle are read.
template <class T>
Grid<T> inverse_fft(Grid<std::complex<T>> half, int cols);

/// The next length from `least` on whose transform is fast: no prime factor above 5.
int fast_length(int least);

/// The signed frequency index that row or column `k` of a transform of length `n` stands for.
inline int signed_frequency(int k, int n) {
  return k <= n / 2 ? k : k - n;
}

}  // namespace hada
