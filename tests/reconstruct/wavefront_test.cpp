#include "reconstruct/wavefront.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace hada {
namespace {

// Three stages that each add up three rows of what the stage before left, and one that looks two
// rows away.
std::vector<double> summed(int rows, std::size_t cells) {
  std::vector<std::vector<double>> left(5, std::vector<double>(std::size_t(rows), 0.0));
  std::vector<Stage> stages;
  stages.push_back({1, [&](int row) { left[0][std::size_t(row)] = 1.0 + row % 7; }});
  for (std::size_t s = 1; s < 5; ++s) {
    const int reach = s == 4 ? 2 : 1;
    stages.push_back({reach, [&left, s, reach, rows](int row) {
                        double sum = 0.0;
                        for (int r = row - reach; r <= row + reach; ++r) {
                          if (r >= 0 && r < rows) sum += left[s - 1][std::size_t(r)];
                        }
                        left[s][std::size_t(row)] = sum;
                      }});
  }
  run_wavefront(rows, cells, stages);
  return left.back();
}

TEST(Wavefront, LeavesWhatStagesOneAfterAnotherWould) {
  constexpr int rows = 200;
  std::vector<double> expected(rows);
  for (int row = 0; row < rows; ++row) expected[std::size_t(row)] = 1.0 + row % 7;
  for (const int reach : {1, 1, 1, 2}) {
    const auto before = expected;
    for (int row = 0; row < rows; ++row) {
      double sum = 0.0;
      for (int r = row - reach; r <= row + reach; ++r) {
        if (r >= 0 && r < rows) sum += before[std::size_t(r)];
      }
      expected[std::size_t(row)] = sum;
    }
  }
  for (const int threads : {1, 2, 3}) {
    set_threads(threads);
    EXPECT_EQ(summed(rows, 10), expected);        // one band
    EXPECT_EQ(summed(rows, 10000000), expected);  // a band for each thread
  }
  set_threads(0);
  EXPECT_EQ(summed(3, 10).size(), 3u);  // fewer rows than the front is long
}

}  // namespace
}  // namespace hada
