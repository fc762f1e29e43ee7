#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace hada {
namespace {

using testing::HasSubstr;

// A vertex in the middle of a square with four folds; `angle` moves one of them off.
std::string vertex_pattern(const std::string& end) {
  return "1 -1 -1 1 -1\n1 1 -1 1 1\n1 1 1 -1 1\n1 -1 1 -1 -1\n"
         "2 0 0 1 0\n3 0 0 0 1\n3 0 0 -1 0\n3 0 0 " +
         end + "\n";
}

TEST(Fold, ChecksFoldsAndCounts) {
  const TemporaryFolder scratch;
  put(scratch / "cross.cp", vertex_pattern("0 -1"));
  const std::string pattern = (scratch / "cross.cp").string();
  EXPECT_THAT(answer("fold check " + pattern).out, HasSubstr("folds flat: every vertex does"));
  EXPECT_THAT(answer("fold states " + pattern).out, HasSubstr("1 state"));
  EXPECT_THAT(answer("fold states " + pattern + " --json").out, HasSubstr("\"states\": 1"));
  const std::string flat = (scratch / "flat.fold").string();
  EXPECT_EQ(answer("fold flat " + pattern + " -o " + flat).code, 0);
  EXPECT_THAT(bytes_of(flat), HasSubstr("faceOrders"));
  EXPECT_THAT(bytes_of(flat), HasSubstr("faces_vertices"));
  EXPECT_EQ(answer("fold convert " + flat + " -o " + (scratch / "a.obj").string()).code, 0);
  EXPECT_THAT(bytes_of(scratch / "a.obj"), HasSubstr("v "));
  const std::string shape = (scratch / "shape.fold").string();
  EXPECT_EQ(answer("fold simulate " + pattern + " --percent 40 -o " + shape).code, 0);
  EXPECT_THAT(bytes_of(shape), HasSubstr("edges_foldAngle"));
}

TEST(Fold, RefusesWhatDoesNotFoldFlat) {
  const TemporaryFolder scratch;
  put(scratch / "bad.cp", vertex_pattern("0.3 -1"));
  const std::string pattern = (scratch / "bad.cp").string();
  EXPECT_THAT(answer("fold check " + pattern).out, HasSubstr("Kawasaki"));
  const Answer said = answer("fold flat " + pattern + " -o " + (scratch / "x.fold").string());
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("Kawasaki"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.fold"));
}

TEST(Fold, ReplaysTheShippedCraneToTheSameBytes) {
  const TemporaryFolder scratch;
  const std::string log = std::string(HADA_SOURCE_DIR) + "/data_synthetic/folds/crane.json";
  for (const char* name : {"one", "two"}) {
    const Answer said = answer("fold replay " + log + " -o " + (scratch / name).string());
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, HasSubstr("0 pairs of faces pass through each other"));
  }
  for (const char* file : {"model.fold", "model.obj", "model.png"}) {
    EXPECT_EQ(bytes_of(scratch / (std::string("one/") + file)),
              bytes_of(scratch / (std::string("two/") + file)));
  }
}

TEST(Fold, ReplaysEveryShippedLogWithoutPaperThroughPaper) {
  const TemporaryFolder scratch;
  const std::filesystem::path folder =
      std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic" / "folds";
  int logs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Answer said =
        answer("fold replay " + entry.path().string() + " -o " + (scratch / "model").string());
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, HasSubstr(" 0 pairs of faces pass through each other"));
    ++logs;
  }
  EXPECT_GE(logs, 6);  // boat, crane, organ, penguin, petal fold, snail
}

TEST(Fold, MeasuresFoldersOfPicturesAndSaysWhatIsNone) {
  const TemporaryFolder scratch;
  std::filesystem::create_directories(scratch / "empty");
  const Answer none = answer("fold measure " + (scratch / "empty").string());
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("empty"));
  put(scratch / "surface/surface.json", "{}");
  const Answer mixed =
      answer("fold measure " + (scratch / "surface").string() + " --lights lights.json");
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("--lights"));
}

}  // namespace
}  // namespace hada
