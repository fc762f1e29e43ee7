#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace hada {
namespace {

using testing::HasSubstr;

TEST(Knit, IsPulledAndItsCrossingsWritten) {
  const TemporaryFolder scratch;
  const std::string out = (scratch / "pulled").string();
  const Answer said = answer("knit pull --stretch 1.2 1.5 --along course -o " + out);
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("10 x 10 stitches pulled to 1.5 along the courses"));
  EXPECT_THAT(bytes_of(scratch / "pulled/crossings.json"), HasSubstr("\"knit_crossings/1\""));
  EXPECT_TRUE(std::filesystem::exists(scratch / "pulled/pulled.png"));
  // By the paper's steps: about a hundred.
  EXPECT_THAT(answer("knit pull --as-the-paper -o " + out).out, HasSubstr("after 109 steps"));
}

TEST(Knit, IsWornOnTheShippedLeg) {
  const TemporaryFolder scratch;
  const Answer said =
      answer("knit wear --courses 24 --wales 20 --rows 120 --nylon-stiffness 0.01 -o " +
             (scratch / "worn").string());
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("0 yarns inside the body"));
  EXPECT_THAT(bytes_of(scratch / "worn/worn.json"), HasSubstr("pressure_kPa"));
  for (const char* name : {"worn.png", "near.png", "density.png", "pressure.png",
                           "transmittance.png", "yarns.glb", "points.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch / (std::string("worn/") + name))) << name;
  }
}

TEST(Knit, IsWornAsAStockingWithHeelAndToe) {
  const TemporaryFolder scratch;
  const Answer said =
      answer("knit wear --shell stocking --courses 40 --wales 32 --rows 120 --turn 90 -o " +
             (scratch / "worn").string());
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("0 yarns inside the body"));
  EXPECT_THAT(bytes_of(scratch / "worn/worn.json"), HasSubstr("\"shell\": \"stocking\""));
  EXPECT_TRUE(std::filesystem::exists(scratch / "worn/density.png"));
}

TEST(Knit, IsCalibratedFromItsCrossings) {
  const TemporaryFolder scratch;
  const std::string out = (scratch / "pulled").string();
  EXPECT_EQ(answer("knit pull --stretch 1.2 1.5 --clamp three-points --noise 0.02 -o " + out).code,
            0);
  const Answer said = answer("knit stiffness " + out + "/crossings.json --load 2.5 --json -o " +
                             (scratch / "k.json").string());
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("\"nylon_N_per_mm\""));
  EXPECT_THAT(bytes_of(scratch / "k.json"), HasSubstr("\"stiffness_ratio\""));
}

TEST(Knit, RefusesWhatItCannotDoInOneSentence) {
  const TemporaryFolder scratch;
  put(scratch / "flat.obj", "v 0 0 0\nv 0 9 0\nv 9 0 0\nv 9 9 0\nf 1 2 3\nf 2 4 3\n");
  const std::string flat = (scratch / "flat.obj").string();
  put(scratch / "short.json",
      R"({"hada": "knit_crossings/1", "courses": 3, "wales": 3, "wale_mm": 1, "course_mm": 1,
          "clamp": "uniform", "repeat": [0, 1],
          "states": [{"along": "wale", "stretch": 1.2, "places_mm": [[0, 0]]}]})");
  const std::vector<std::string> bad{"knit wear " + flat,
                                     "knit wear nothing.obj",
                                     "knit wear --from 600 --to 100",
                                     "knit wear --from nan",
                                     "knit wear --courses 1",
                                     "knit wear --girth -1",
                                     "knit wear --shell stocking --loops",
                                     "knit wear --shell stocking --from 100",
                                     "knit wear --shell stocking --wales 8",
                                     "knit pull --stretch 0",
                                     "knit pull --along the-bias",
                                     "knit pull --material nothing.json"};
  for (const std::string& words : bad) {
    const Answer said = answer(words + " -o " + (scratch / "x").string());
    EXPECT_EQ(said.code, 2) << words;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << words << said.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "x")) << words;
  }
}

TEST(Knit, ShowsAnExampleOfEachCommand) {
  for (const char* name : {"pull", "wear", "stiffness"}) {
    EXPECT_THAT(answer(std::string("knit ") + name + " --help").out,
                HasSubstr("Example:\n  hada knit " + std::string(name)));
  }
}

}  // namespace
}  // namespace hada
