#include "core/parallel.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

class Parallel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_threads(GetParam()); }
  void TearDown() override { set_threads(0); }
};
INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 3, 8));

TEST_P(Parallel, VisitsEveryIndexOnce) {
  for (const int count : {0, 1, 2, 7, 100}) {
    std::vector<int> visits(std::size_t(count), 0);
    for_each_index(count, [&](int i) { ++visits[std::size_t(i)]; });
    EXPECT_EQ(visits, std::vector<int>(std::size_t(count), 1)) << count;
  }
}

TEST_P(Parallel, CutsSlicesThatDifferByOneAtMost) {
  std::vector<int> length(100, 0);  // by the first index of the slice
  for_slices(100, [&](int begin, int end) { length[std::size_t(begin)] = end - begin; });
  for (const int l : length) {
    if (l == 0) continue;
    EXPECT_NEAR(l, 100.0 / GetParam(), 1.0);
  }
}

TEST_P(Parallel, ThrowsTheFirstExceptionInTheOrderOfTheSlices) {
  const auto work = [](int i) {
    if (i >= 3) throw std::runtime_error(std::to_string(i));
  };
  try {
    for_each_index(50, work);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "3");
  }
}

TEST_P(Parallel, FinishesTheOtherSlicesBeforeItThrows) {
  std::vector<int> done(8, 0);
  EXPECT_THROW(for_each_index(8,
                              [&](int i) {
                                if (i == 0) throw std::runtime_error("first");
                                done[std::size_t(i)] = 1;
                              }),
               std::runtime_error);
  if (GetParam() != 8) return;
  EXPECT_EQ(done, (std::vector<int>{0, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Threads, AreNotAskedForTwice) {
  set_threads(3);
  std::vector<int> slices(3, 0);
  for_each_index(3, [&](int i) {
    for_slices(100, [&](int begin, int end) {
      EXPECT_EQ(begin, 0);
      EXPECT_EQ(end, 100);
      ++slices[std::size_t(i)];
    });
  });
  EXPECT_EQ(slices, (std::vector<int>{1, 1, 1}));
  set_threads(4);
  std::vector<int> ends(2, 0);
  for_slices(2, [&](int slice, int) {
    for_slices(100, [&, slice](int begin, int end) {
      if (begin == 0) ends[std::size_t(slice)] = end;
    });
  });
  EXPECT_EQ(ends, (std::vector<int>{50, 50}));
  set_threads(0);
}

TEST(Threads, AreAsManyAsAsked) {
  set_threads(5);
  EXPECT_EQ(threads(), 5);
  set_threads(0);
  EXPECT_GE(threads(), 1);
}

}  // namespace
}  // namespace hada
