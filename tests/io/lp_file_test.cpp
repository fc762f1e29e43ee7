#include "io/lp_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"
#include "io/lights_file.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

std::vector<Light> read_text(const std::string& text) {
  const TemporaryFolder folder;
  put(folder / "dome.lp", text);
  return read_lp(folder / "dome.lp");
}

std::vector<Light> some_lights(Seed seed) {
  std::vector<Light> lights(1 + std::size_t(9 * uniform(seed, 0)));
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const int i = int(k);
    lights[k].image = "picture " + std::to_string(k) + (k % 2 ? " 2.tif" : "");
    lights[k].direction =
        Eigen::Vector3d(uniform(seed, i, 1) - 0.5, uniform(seed, i, 2) - 0.5, uniform(seed, i, 3))
            .normalized();
  }
  return lights;
}

RC_GTEST_PROP(LpFile, ReturnsFromItsTextWhatWasWritten, (std::uint64_t seed)) {
  const auto lights = some_lights(seed);
  const auto again = read_text(lp_text(lights));
  RC_ASSERT(again.size() == lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k) {
    RC_ASSERT(again[k].image == lights[k].image);
    // Ten decimals: half a unit of the last in each of three numbers.
    RC_ASSERT((again[k].direction - lights[k].direction).norm() < 1e-10);
    RC_ASSERT(again[k].strength == Eigen::Vector3d::Ones());
  }
}

TEST(LpFile, ReadsWhatOthersWrite) {
  const auto lights = read_text(
      "\xEF\xBB\xBF 3 \r\n"
      "C:\\rti\\jpeg exports\\coin 01.jpg\t0.6 0 .8\r\n"
      "\r\n"
      "../jpeg exports/coin 02.jpg  -3e2 0.0 4e2\r\n"
      "coin03.jpg 0 +1 0\r\n\r\n");
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_EQ(lights[0].image, "coin 01.jpg");
  EXPECT_EQ(lights[1].image, "coin 02.jpg");
  EXPECT_EQ(lights[2].image, "coin03.jpg");
  // Three quotients of numbers near 1.
  EXPECT_LT((lights[0].direction - Eigen::Vector3d(0.6, 0.0, 0.8)).norm(), 1e-15);
  EXPECT_LT((lights[1].direction - Eigen::Vector3d(-0.6, 0.0, 0.8)).norm(), 1e-15);
  EXPECT_EQ(lights[2].direction, Eigen::Vector3d::UnitY());
}

TEST(LpFile, NamesTheLineOfEveryFlaw) {
  const auto error = [](const std::string& text) { return error_of([&] { read_text(text); }); };
  EXPECT_THAT(error(""), HasSubstr("dome.lp: is empty"));
  EXPECT_THAT(error("a.jpg 0 0 1\n"), HasSubstr("line 1: must be the number of lights"));
  EXPECT_THAT(error("-1\n"), HasSubstr("line 1: must be the number of lights"));
  EXPECT_THAT(error("0\n"), HasSubstr("line 1: must be the number of lights"));
  EXPECT_THAT(error("2\na.jpg 0 0 1\n"), HasSubstr("2 lights are announced, but 1 follows"));
  EXPECT_THAT(error("1\na.jpg 0 0 1\nb.jpg 0 0 1\n"), HasSubstr("1 light is announced, but 2"));
  EXPECT_THAT(error("1\n\na.jpg 0 1\n"), HasSubstr("line 3: must be"));
  EXPECT_THAT(error("1\n0 0 1\n"), HasSubstr("line 2: must be"));
  EXPECT_THAT(error("1\na.jpg 0 x 1\n"), HasSubstr("line 2: must be"));
  EXPECT_THAT(error("1\na.jpg 0 nan 1\n"), HasSubstr("line 2: must be"));
  EXPECT_THAT(error("1\na.jpg 0 1e999 1\n"), HasSubstr("line 2: must be"));
  EXPECT_THAT(error("1\na.jpg 0 0 0\n"), HasSubstr("line 2: its direction has no length"));
  EXPECT_THAT(error("1\na.jpg 0 0 -1\n"), HasSubstr("z must point to the camera"));
  EXPECT_THAT(error_of([] { read_lp("/nowhere/dome.lp"); }), HasSubstr("/nowhere/dome.lp"));
}

TEST(LpFile, IsALightsFileWithoutStrengths) {
  const TemporaryFolder folder;
  put(folder / "dome.LP", "1\na.jpg 0 0 5\n");
  const LightsFile file = read_lights(folder / "dome.LP");
  ASSERT_EQ(file.lights.size(), 1u);
  EXPECT_EQ(file.lights[0].direction, Eigen::Vector3d::UnitZ());
  EXPECT_FALSE(file.strengths_measured);
  EXPECT_TRUE(file.encoding.empty());
}

RC_GTEST_PROP(LpFile, SurvivesCutsAndChangedBytes,
              (std::uint64_t seed, std::uint16_t place, char byte, bool cut)) {
  std::string text = lp_text(some_lights(seed));
  const std::size_t at = place % text.size();
  if (cut)
    text.resize(at);
  else
    text[at] = byte;
  error_of([&] { read_text(text); });
}

}  // namespace
}  // namespace hada
