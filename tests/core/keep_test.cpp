#include "core/keep.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/grid.h"

namespace hada {
namespace {

Grid<int> numbered(Keep keep) {
  Grid<int> grid(300, 4000, 0, keep);
  for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = int(i);
  return grid;
}

// Of this process, backed by files and shared memory, in MB.
double mapped_megabytes() {
  double sum = 0.0;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "RssFile:" && word != "RssShmem:") continue;
    double kilobytes = 0.0;
    status >> kilobytes;
    sum += kilobytes / 1024.0;
  }
  return sum;
}

TEST(Keep, HoldsTheSameValuesOnDisk) {
  const Grid<int> on_disk = numbered(Keep::on_disk);
  EXPECT_EQ(on_disk.keep(), Keep::on_disk);
  EXPECT_EQ(on_disk, numbered(Keep::in_memory));
}

TEST(Keep, LosesNothingWhenLetGo) {
  const Grid<int> grid = numbered(Keep::on_disk);
  grid.let_go(17, 200);
  EXPECT_EQ(grid, numbered(Keep::in_memory));
  grid.let_go();
  EXPECT_EQ(grid, numbered(Keep::in_memory));
  const Grid<int> in_memory = numbered(Keep::in_memory);
  in_memory.let_go();  // does nothing
  EXPECT_EQ(in_memory, grid);
}

TEST(Keep, GivesMemoryBack) {
  const Grid<int> grid = numbered(Keep::on_disk);  // 4.6 MB
  const double before = mapped_megabytes();
  grid.let_go();
  EXPECT_LT(mapped_megabytes(), before - 4.0);
}

TEST(Keep, GoesWithMovesAndCopies) {
  Grid<int> grid = numbered(Keep::on_disk);
  Grid<int> copy = grid;
  EXPECT_EQ(copy.keep(), Keep::on_disk);
  const int* const values = grid.data();
  const Grid<int> moved = std::move(grid);
  EXPECT_EQ(moved.data(), values);
  copy = numbered(Keep::in_memory);
  EXPECT_EQ(copy.keep(), Keep::in_memory);
  EXPECT_EQ(copy, moved);
  EXPECT_EQ(crop(moved, 0, 0, 2, 2).keep(), Keep::in_memory);
}

TEST(Keep, TakesMemoryWhereTheDiskCannotBeWritten) {
  setenv("TMPDIR", "/nowhere", 1);
  const Grid<int> grid = numbered(Keep::on_disk);
  unsetenv("TMPDIR");
  grid.let_go();
  EXPECT_EQ(grid, numbered(Keep::in_memory));
}

TEST(Keep, PutsLargePicturesOnDisk) {
  EXPECT_EQ(keep_of_pictures(std::size_t(200) << 20), Keep::in_memory);
  EXPECT_EQ(keep_of_pictures(std::size_t(2300) << 20), Keep::on_disk);
}

}  // namespace
}  // namespace hada
