#include "reconstruct/row_arithmetic.h"

#include <bit>

#include "reconstruct/clones.h"

namespace hada::row_kernels {

HADA_CLONES_AVX512 void subtract(int n, float off, float* __restrict x) {
  for (int i = 0; i < n; ++i) x[i] -= off;
}

HADA_CLONES_AVX512 void add(int n, const float* a, const float* b, float* __restrict sum) {
  for (int i = 0; i < n; ++i) sum[i] = a[i] + b[i];
}

HADA_CLONES_AVX512 void add_and_deal(int n, const float* a, const float* b, float* __restrict even,
                                     float* __restrict odd) {
  for (int i = 0; i < n; ++i) {
    even[i] = a[2 * i] + b[2 * i];
    odd[i] = a[2 * i + 1] + b[2 * i + 1];
  }
}

HADA_CLONES_AVX512 void add_times(int n, float factor, const float* x, float* __restrict total) {
  for (int i = 0; i < n; ++i) total[i] += factor * x[i];
}

HADA_CLONES_AVX512 void deal(int n, const float* row, float* __restrict even,
                             float* __restrict odd) {
  for (int i = 0; i < n; ++i) {
    even[i] = row[2 * i];
    odd[i] = row[2 * i + 1];
  }
}

HADA_CLONES_AVX512 void deal(int n, const std::uint8_t* row, std::uint8_t* __restrict even,
                             std::uint8_t* __restrict odd) {
  for (int i = 0; i < n; ++i) {
    even[i] = row[2 * i];
    odd[i] = row[2 * i + 1];
  }
}

HADA_CLONES_AVX512 void gather(int n, const float* even, const float* odd, float* __restrict row) {
  const int pairs = n / 2;
  for (int i = 0; i < pairs; ++i) {
    row[2 * i] = even[i];
    row[2 * i + 1] = odd[i];
  }
  if (n % 2 == 1) row[n - 1] = even[pairs];
}

HADA_CLONES_AVX512 void add_gathered(int n, float factor, const float* even, const float* odd,
                                     float* __restrict row) {
  const int pairs = n / 2;
  for (int i = 0; i < pairs; ++i) {
    row[2 * i] += factor * even[i];
    row[2 * i + 1] += factor * odd[i];
  }
  if (n % 2 == 1) row[n - 1] += factor * even[pairs];
}

HADA_CLONES_AVX512 float largest(int n, const float* x) {
  // Without their sign floats are ordered as the integers with the same bits are, and of those the
  // compiler takes many at a time.
  std::int32_t most = 0;
  for (int i = 0; i < n; ++i) {
    const std::int32_t size = std::bit_cast<std::int32_t>(x[i]) & 0x7fffffff;
    most = size > most ? size : most;
  }
  return std::bit_cast<float>(most);
}

HADA_CLONES_AVX512 std::size_t count_positive(std::size_t n, const std::uint8_t* x) {
  // In bytes, as many at a time as cannot overflow one.
  constexpr int lanes = 32;
  constexpr std::size_t at_once = lanes * 255;
  std::size_t count = 0;
  for (std::size_t first = 0; first < n; first += at_once) {
    std::uint8_t part[lanes] = {};
    const std::size_t end = n - first < at_once ? n : first + at_once;
    std::size_t i = first;
    for (; i + lanes <= end; i += lanes) {
      for (int lane = 0; lane < lanes; ++lane)
        part[lane] = std::uint8_t(part[lane] + (x[i + lane] > 0));
    }
    for (; i < end; ++i) count += x[i] > 0;
    for (const std::uint8_t p : part) count += p;
  }
  return count;
}

HADA_CLONES_AVX512 std::size_t count_positive(std::size_t n, const float* x) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) count += x[i] > 0.0f;
  return count;
}

HADA_CLONES_AVX512 double sum(int n, const float* x) {
  // Lanes whose order of adding does not depend on the width of the vectors.
  constexpr int lanes = 8;
  double part[lanes] = {};
  int i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (int lane = 0; lane < lanes; ++lane) part[lane] += double(x[i + lane]);
  }
  for (; i < n; ++i) part[i % lanes] += double(x[i]);
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

HADA_CLONES_AVX512 double dot(int n, const float* x, const float* y) {
  constexpr int lanes = 8;
  double part[lanes] = {};
  int i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (int lane = 0; lane < lanes; ++lane) {
      part[lane] += double(x[i + lane]) * double(y[i + lane]);
    }
  }
  for (; i < n; ++i) part[i % lanes] += double(x[i]) * double(y[i]);
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

}  // namespace hada::row_kernels
