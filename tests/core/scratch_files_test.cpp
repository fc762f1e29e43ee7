#include "core/scratch_files.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/grid.h"

namespace hada {
namespace {

Grid<int> numbered(std::pmr::memory_resource* memory) {
  Grid<int> grid(300, 4000, 0, memory);
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

TEST(ScratchFiles, HoldTheSameValues) {
  const Grid<int> on_disk = numbered(scratch_files());
  EXPECT_EQ(on_disk.memory(), scratch_files());
  EXPECT_EQ(on_disk, numbered(nullptr));
}

TEST(ScratchFiles, LoseNothingWhenLetGo) {
  const Grid<int> grid = numbered(scratch_files());
  grid.let_go(17, 200);
  EXPECT_EQ(grid, numbered(nullptr));
  grid.let_go();
  EXPECT_EQ(grid, numbered(nullptr));
  const Grid<int> in_memory = numbered(nullptr);
  in_memory.let_go();  // does nothing
  EXPECT_EQ(in_memory, grid);
}

TEST(ScratchFiles, GiveMemoryBack) {
  const Grid<int> grid = numbered(scratch_files());  // 4.6 MB
  const double before = mapped_megabytes();
  grid.let_go();
  EXPECT_LT(mapped_megabytes(), before - 4.0);
}

TEST(ScratchFiles, GoWithMovesAndCopies) {
  Grid<int> grid = numbered(scratch_files());
  Grid<int> copy = grid;
  EXPECT_EQ(copy.memory(), scratch_files());
  const int* const values = grid.data();
  const Grid<int> moved = std::move(grid);
  EXPECT_EQ(moved.data(), values);
  copy = numbered(nullptr);
  EXPECT_EQ(copy.memory(), nullptr);
  EXPECT_EQ(copy, moved);
  EXPECT_EQ(crop(moved, 0, 0, 2, 2).memory(), scratch_files());
}

TEST(ScratchFiles, TakeMemoryWhereTheDiskCannotBeWritten) {
  setenv("TMPDIR", "/nowhere", 1);
  const Grid<int> grid = numbered(scratch_files());
  unsetenv("TMPDIR");
  grid.let_go();
  EXPECT_EQ(grid, numbered(nullptr));
}

TEST(ScratchFiles, AreForLargePictures) {
  EXPECT_EQ(memory_for_pictures(std::size_t(200) << 20), nullptr);
  EXPECT_EQ(memory_for_pictures(std::size_t(2300) << 20), scratch_files());
}

}  // namespace
}  // namespace hada
