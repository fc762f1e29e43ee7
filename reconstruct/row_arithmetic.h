#pragma once

#include <cstddef>
#include <cstdint>

/// What the rows of the multigrid solver need beside its equations: sums, copies in another order,
/// largest values. Compiled for several instruction sets, all of which give the same bytes.
namespace hada::row_kernels {

/// sum = a + b.
void add(int n, const float* a, const float* b, float* __restrict sum);
/// even[i] = a[2 i] + b[2 i], odd[i] = a[2 i + 1] + b[2 i + 1].
void add_and_deal(int n, const float* a, const float* b, float* __restrict even,
                  float* __restrict odd);
/// total += factor x.
void add_times(int n, float factor, const float* x, float* __restrict total);
/// x -= off.
void subtract(int n, float off, float* __restrict x);
/// even[i] = row[2 i], odd[i] = row[2 i + 1].
void deal(int n, const float* row, float* __restrict even, float* __restrict odd);
void deal(int n, const std::uint8_t* row, std::uint8_t* __restrict even,
          std::uint8_t* __restrict odd);
/// row[2 i] = even[i], row[2 i + 1] = odd[i]; n values of a row.
void gather(int n, const float* even, const float* odd, float* __restrict row);
/// row[2 i] += factor even[i], row[2 i + 1] += factor odd[i]; n values of a row.
void add_gathered(int n, float factor, const float* even, const float* odd, float* __restrict row);

/// The largest |x|.
float largest(int n, const float* x);
/// How many are above 0.
std::size_t count_positive(std::size_t n, const std::uint8_t* x);
std::size_t count_positive(std::size_t n, const float* x);
double sum(int n, const float* x);
double dot(int n, const float* x, const float* y);

}  // namespace hada::row_kernels
