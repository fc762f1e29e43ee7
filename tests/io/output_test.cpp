#include "io/output.h"

#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(Output, ShowsItsFilesOnlyAfterCommit) {
  const TemporaryFolder folder;
  put(folder / "out/a.txt", "old");
  Output output(folder / "out");
  put(output.file("a.txt"), "new");
  put(output.file("deep/b.txt"), "b");
  EXPECT_EQ(bytes_of(folder / "out/a.txt"), "old");
  EXPECT_FALSE(fs::exists(folder / "out/deep"));
  output.commit();
  EXPECT_EQ(bytes_of(folder / "out/a.txt"), "new");
  EXPECT_EQ(bytes_of(folder / "out/deep/b.txt"), "b");
  EXPECT_EQ(entries(folder / "out"), 2);  // and no scratch
}

TEST(Output, LeavesNothingBehindWithoutCommit) {
  const TemporaryFolder folder;
  put(folder / "there/a.txt", "old");
  {
    Output fresh(folder / "new/one/two/");
    put(fresh.file("a.txt"), "new");
    Output old(folder / "there");
    put(old.file("a.txt"), "new");
  }
  EXPECT_FALSE(fs::exists(folder / "new"));
  EXPECT_EQ(bytes_of(folder / "there/a.txt"), "old");
  EXPECT_EQ(entries(folder / "there"), 1);
}

TEST(Output, RenamesNothingIfOneFileCannotTakeItsPlace) {
  const TemporaryFolder folder;
  put(folder / "out/a.txt", "old");
  fs::create_directories(folder / "out/b.txt");
  {
    Output output(folder / "out");
    put(output.file("a.txt"), "new");
    put(output.file("b.txt"), "new");
    EXPECT_THAT(error_of([&] { output.commit(); }), HasSubstr("b.txt: is a folder"));
  }
  {
    Output output(folder / "out");
    put(output.file("a.txt"), "new");
    output.file("c.txt");
    EXPECT_THAT(error_of([&] { output.commit(); }), HasSubstr("c.txt: was not written"));
  }
  EXPECT_EQ(bytes_of(folder / "out/a.txt"), "old");
  EXPECT_EQ(entries(folder / "out"), 2);
}

TEST(Output, SaysWhereItMayNotWrite) {
  const TemporaryFolder folder;
  put(folder / "file", "x");
  EXPECT_THAT(error_of([&] { Output output(folder / "file"); }), HasSubstr("file: is a file"));
  EXPECT_NE(error_of([&] { Output output(folder / "file/below"); }), "");
  EXPECT_NE(error_of([&] { Output output("/proc/hada/out"); }), "");
  EXPECT_NE(error_of([&] { Output output("/proc"); }), "");
}

TEST(WriteText, ReplacesTheWholeFile) {
  const TemporaryFolder folder;
  write_text(folder / "new/a.txt", "one");
  write_text(folder / "new/a.txt", "two");
  EXPECT_EQ(bytes_of(folder / "new/a.txt"), "two");
  EXPECT_EQ(entries(folder / "new"), 1);
  EXPECT_THAT(error_of([&] { write_text(folder / "new", "x"); }), HasSubstr("is a folder"));
}

TEST(WriteText, WritesIntoADeviceInsteadOfReplacingIt) {
  write_text("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THAT(error_of([&] { write_text("/dev/full", "x"); }), HasSubstr("cannot be written"));
}

TEST(Interrupt, RemovesTheScratchOfEveryOutputAndEndsWith130) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  for (const int signal : {SIGINT, SIGTERM}) {
    // Named without chance: the child runs the whole test again.
    const fs::path folder = fs::temp_directory_path() / "hada-test-interrupt";
    fs::remove_all(folder);
    put(folder / "there/a.txt", "old");
    EXPECT_EXIT(
        {
          clean_up_on_interrupt();
          Output fresh(folder / "new/deep");
          Output old(folder / "there");
          put(fresh.file("a.txt"), "half");
          put(old.file("a.txt"), "half");
          kill(getpid(), signal);
          for (;;) pause();
        },
        testing::ExitedWithCode(130), "");
    EXPECT_FALSE(fs::exists(folder / "new"));
    EXPECT_EQ(bytes_of(folder / "there/a.txt"), "old");
    EXPECT_EQ(entries(folder / "there"), 1);
    fs::remove_all(folder);
  }
}

}  // namespace
}  // namespace hada
