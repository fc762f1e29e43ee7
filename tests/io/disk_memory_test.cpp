#include "io/disk_memory.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/grid.h"
#include "temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

TEST(DiskMemory, KeepsLargeAndSmallArraysWithoutANameInTheFolder) {
  const TemporaryFolder folder;
  DiskMemory disk(folder.path());
  Grid<int> large(1024, 1024, 7, &disk);
  Grid<int> small(2, 3, 5, &disk);
  large(1000, 3) = 9;
  const Grid<int> copy = large;
  EXPECT_EQ(copy.memory(), &disk);
  EXPECT_EQ(copy(1000, 3), 9);
  EXPECT_EQ(copy(1023, 1023), 7);
  EXPECT_EQ(small(1, 2), 5);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  Grid<int> moved;
  moved = std::move(large);
  EXPECT_EQ(moved.memory(), &disk);
  EXPECT_EQ(moved, copy);
}

TEST(DiskMemory, SaysWhereThereIsNoRoom) {
  const TemporaryFolder folder;
  DiskMemory missing(folder / "none");
  EXPECT_THAT(error_of([&] { const Grid<char> grid(2048, 2048, 0, &missing); }),
              HasSubstr("none: has no room for another 5 MB"));
  DiskMemory disk(folder.path());
  EXPECT_THAT(error_of([&] { (void)disk.allocate(std::size_t(1) << 60); }),
              HasSubstr("has no room"));
}

}  // namespace
}  // namespace hada
