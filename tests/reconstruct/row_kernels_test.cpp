#include "reconstruct/row_kernels.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/coarsen_kernels.h"

namespace hada {
namespace {

TEST(RowKernels, RelaxToTheMeanOfTheNeighboursWhateverTheirNumber) {
  constexpr int n = 48;  // more than the widest vector, with a rest
  const std::vector<float> one(n, 1.0f), two(n, 2.0f), three(n, 3.0f), zero(n, 0.0f);
  std::vector<float> x(n, 9.0f);
  std::vector<std::uint8_t> code(n);
  for (int i = 0; i < n; ++i) code[std::size_t(i)] = row_kernels::edge_code(i % 5);
  row_kernels::relax(n, 0.0f, x.data(), {one.data(), two.data(), three.data(), zero.data()},
                     zero.data(), code.data());
  for (int i = 0; i < n; ++i) {
    const int edges = i % 5;  // 1 over them is exact, or rounded as a division is
    EXPECT_EQ(x[std::size_t(i)], edges == 0 ? 0.0f : 6.0f * (1.0f / float(edges))) << edges;
  }
}

TEST(RowKernels, OverRelaxBeyondWhereTheEquationHolds) {
  constexpr int n = 20;
  const std::vector<float> one(n, 1.0f), quarter(n, 0.25f), eight(n, 8.0f);
  const std::vector<std::uint8_t> code(n, row_kernels::edge_code(4));
  const row_kernels::Around around{one.data(), one.data(), one.data(), one.data()};
  std::vector<float> x(n, 2.0f), weighted(n, 2.0f), fresh(n, 9.0f);
  // The equation holds at (8 + 4) / 4 = 3: one beyond 2, half of that further with a factor of 1.5.
  row_kernels::over_relax(n, 1.5f, 0.0f, x.data(), around, eight.data(), code.data());
  row_kernels::over_relax(n, 1.5f, weighted.data(), around, around, eight.data(), quarter.data(),
                          nullptr);
  row_kernels::relax_from_zero(n, 1.5f, fresh.data(), eight.data(), code.data());
  EXPECT_EQ(x, std::vector<float>(n, 3.5f));
  EXPECT_EQ(weighted, x);
  EXPECT_EQ(fresh, std::vector<float>(n, 3.0f));
}

TEST(RowKernels, RoundWhatTheyRelaxToMultiples) {
  constexpr int n = 20;
  constexpr float step = 0.25f;
  const std::vector<float> zero(n, 0.0f);
  const std::vector<std::uint8_t> code(n, row_kernels::edge_code(4));
  const row_kernels::Around around{zero.data(), zero.data(), zero.data(), zero.data()};
  std::vector<float> right(n), x(n, 9.0f), over(n, 0.0f);
  for (int i = 0; i < n; ++i) right[std::size_t(i)] = 0.37f * float(i - 10);
  row_kernels::relax(n, 3.0f * 0x1p22f * step, x.data(), around, right.data(), code.data());
  row_kernels::over_relax(n, 1.5f, 3.0f * 0x1p22f * step, over.data(), around, right.data(),
                          code.data());
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(x[i], step * std::nearbyint(0.25f * right[i] / step)) << i;
    EXPECT_EQ(over[i], step * std::nearbyint(1.5f * (0.25f * right[i]) / step)) << i;
  }
}

TEST(RowKernels, GiveTheSameBytesWhetherEvenCellsAreMarkedOrNot) {
  constexpr int n = 40;  // two runs of 16 and a rest
  const std::vector<float> one(n, 1.0f), quarter(n, 0.25f);
  std::vector<float> value(n + 2), right(n);
  for (int i = 0; i < n + 2; ++i) value[std::size_t(i)] = 0.37f * float(i * i % 11);
  for (int i = 0; i < n; ++i) right[std::size_t(i)] = 0.11f * float(i % 5);
  const row_kernels::Around around{value.data(), value.data() + 1, value.data() + 2, right.data()};
  const row_kernels::Around weight{one.data(), one.data(), one.data(), one.data()};
  std::vector<std::uint8_t> even(n, 0);
  coarsen_kernels::find_even(n, weight, quarter.data(), quarter.data(), quarter.data(),
                             even.data());
  EXPECT_EQ(even, std::vector<std::uint8_t>(n, 1));
  even[20] = 0;  // the second run is not read as even
  std::vector<std::vector<float>> found;
  for (const std::uint8_t* const marks :
       {static_cast<const std::uint8_t*>(nullptr), static_cast<const std::uint8_t*>(even.data())}) {
    std::vector<float> x = right, over = right, rest(n), carried(2 * n, 1.0f);
    row_kernels::relax(n, x.data(), around, weight, right.data(), quarter.data(), marks);
    row_kernels::over_relax(n, 1.2f, over.data(), around, weight, right.data(), quarter.data(),
                            marks);
    row_kernels::residual(n, rest.data(), x.data(), around, weight, right.data(), quarter.data(),
                          marks);
    const row_kernels::Corner corner{
        value.data(),     value.data() + 1, one.data(),     quarter.data(),
        value.data() + 2, one.data(),       quarter.data(), marks};
    const std::vector<float> alive(2 * n, 1.0f);
    row_kernels::add_carried(n, 1.5f, carried.data(), corner, corner, alive.data());
    std::vector<float> once(2 * n, 0.0f), twice(2 * n, 0.0f);
    row_kernels::add_carried(n, 1.0f, once.data(), corner, corner, alive.data());
    row_kernels::add_carried(n, 2.0f, twice.data(), corner, corner, alive.data());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(twice[i], 2.0f * once[i]);
    for (const auto* part : {&x, &over, &rest, &carried}) found.push_back(*part);
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found[i], found[i + 4]);
}

TEST(RowKernels, AgreeOnResidualsWithAndWithoutWeights) {
  constexpr int n = 20;
  std::vector<float> up(n), down(n), left(n), right(n), x(n), rhs(n);
  for (int i = 0; i < n; ++i) {
    up[std::size_t(i)] = float(i);
    down[std::size_t(i)] = float(2 * i);
    left[std::size_t(i)] = float(n - i);
    right[std::size_t(i)] = 1.0f;
    x[std::size_t(i)] = float(i % 3);
    rhs[std::size_t(i)] = float(i % 4);
  }
  const std::vector<float> ones(n, 1.0f);
  const std::vector<std::uint8_t> code(n, row_kernels::edge_code(4));
  const row_kernels::Around around{up.data(), down.data(), left.data(), right.data()};
  std::vector<float> plain(n), weighted(n), exact(n), in_place = rhs;
  row_kernels::residual(n, plain.data(), x.data(), around, rhs.data(), code.data());
  row_kernels::residual(n, weighted.data(), x.data(), around,
                        {ones.data(), ones.data(), ones.data(), ones.data()}, rhs.data(),
                        ones.data(), nullptr);
  row_kernels::exact_residual(n, exact.data(), x.data(), around, rhs.data(), code.data(),
                              {code.data(), code.data(), code.data(), code.data()});
  row_kernels::exact_residual(n, in_place.data(), x.data(), around, in_place.data(), code.data(),
                              {code.data(), code.data(), code.data(), code.data()});
  EXPECT_EQ(plain, weighted);  // small whole numbers: nothing is rounded
  EXPECT_EQ(plain, exact);
  EXPECT_EQ(plain, in_place);
}

TEST(RowKernels, CountTheEdgesOfEveryPixelOfAMask) {
  // Any value but 0 is inside; the place before and after a row are outside here.
  const std::vector<std::uint8_t> above = {0, 1, 1, 0, 0};
  const std::vector<std::uint8_t> here = {0, 1, 255, 1, 0, 1, 0};
  const std::vector<std::uint8_t> below = {1, 1, 0, 1, 0};
  std::vector<std::uint8_t> codes(5);
  row_kernels::edge_codes(5, above.data(), here.data() + 1, below.data(), codes.data());
  const std::vector<std::uint8_t> expected = {row_kernels::edge_code(2), row_kernels::edge_code(4),
                                              row_kernels::edge_code(2), 0, 0};
  EXPECT_EQ(codes, expected);
}

}  // namespace
}  // namespace hada
