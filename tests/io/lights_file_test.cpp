#include "io/lights_file.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

LightsFile read_text(const std::string& text) {
  const TemporaryFolder folder;
  put(folder / "lights.json", text);
  return read_lights(folder / "lights.json");
}

// A lights file of any kind, drawn from `seed`.
LightsFile some_lights(Seed seed) {
  LightsFile file;
  const int count = 1 + int(12 * uniform(seed, 0));
  for (int i = 0; i < count; ++i) {
    const auto draw = [&](int k) { return uniform(seed, i, 1, k); };
    Light light;
    light.image = "picture " + std::to_string(i) + ".png";
    light.direction = Eigen::Vector3d(draw(0) - 0.5, draw(1) - 0.5, 0.1 + draw(2)).normalized();
    if (draw(3) < 0.5)
      light.strength = {draw(4), draw(5), draw(6)};
    else
      light.strength.setConstant(draw(4));
    if (draw(7) < 0.7) light.direction_sigma = 0.1 * draw(8);
    if (draw(9) < 0.3) light.position = Eigen::Vector3d(draw(10), draw(11), 300.0 * draw(12));
    file.lights.push_back(light);
  }
  if (uniform(seed, 3) < 0.5) file.position_unit = Unit::px;
  file.errors.resize(std::size_t(4 * uniform(seed, 4)));
  for (std::size_t m = 0; m < file.errors.size(); ++m) {
    for (int i = 0; i < count; ++i) {
      const auto draw = [&](int k) { return 0.01 * gaussian(seed, i, 3 + int(m), k); };
      file.errors[m].emplace_back(draw(0), draw(1), draw(2));
    }
  }
  for (int i = 0; i < int(3 * uniform(seed, 1)); ++i) {
    const auto draw = [&](int k) { return uniform(seed, i, 2, k); };
    Sphere sphere{draw(0) < 0.5 ? SphereKind::matte : SphereKind::chrome,
                  {500 * draw(1), 400 * draw(2)},
                  90 * draw(3),
                  draw(4) < 0.5 ? 0.0 : draw(5),
                  std::nullopt};
    if (draw(6) < 0.5) sphere.diameter_mm = 38.0 * draw(7);
    file.spheres.push_back(sphere);
  }
  if (uniform(seed, 5) < 0.5) {
    file.highlights_px.resize(std::size_t(count));
    for (int i = 0; i < count; ++i) {
      if (i % 3 != 0) file.highlights_px[std::size_t(i)] = {{700.0 * uniform(seed, i, 9), 3.5}};
    }
  }
  file.encoding = uniform(seed, 2) < 0.5 ? "" : "srgb";
  return file;
}

RC_GTEST_PROP(LightsFile, ReturnsFromItsTextWhatWasWritten, (std::uint64_t seed)) {
  const LightsFile file = some_lights(seed);
  const LightsFile again = read_text(lights_text(file));
  RC_ASSERT(again.encoding == file.encoding);
  RC_ASSERT(again.lights.size() == file.lights.size());
  for (std::size_t i = 0; i < file.lights.size(); ++i) {
    const Light& a = file.lights[i];
    const Light& b = again.lights[i];
    RC_ASSERT(a.image == b.image);
    // Normalised once more: a few roundings of numbers below 1.
    RC_ASSERT((a.direction - b.direction).norm() < 1e-15);
    RC_ASSERT(a.strength == b.strength);
    RC_ASSERT(std::abs(a.direction_sigma - b.direction_sigma) < 1e-16);  // of 0.1, via degrees
    RC_ASSERT(a.position == b.position);
  }
  const bool near = std::any_of(file.lights.begin(), file.lights.end(),
                                [](const Light& light) { return light.position.has_value(); });
  RC_ASSERT(!near || again.position_unit == file.position_unit);
  RC_ASSERT(again.errors == file.errors);
  RC_ASSERT(again.highlights_px == file.highlights_px);
  RC_ASSERT(again.spheres.size() == file.spheres.size());
  for (std::size_t i = 0; i < file.spheres.size(); ++i) {
    RC_ASSERT(again.spheres[i].kind == file.spheres[i].kind);
    RC_ASSERT(again.spheres[i].center_px == file.spheres[i].center_px);
    RC_ASSERT(again.spheres[i].radius_px == file.spheres[i].radius_px);
    RC_ASSERT(again.spheres[i].sigma_px == file.spheres[i].sigma_px);
    RC_ASSERT(again.spheres[i].diameter_mm == file.spheres[i].diameter_mm);
  }
}

TEST(LightsFile, ReadsTheShortestFileThatAPersonWouldWrite) {
  const auto file = read_text(
      R"({"hada":"lights/1","lights":[{"image":"a.png","direction":[0,0,2],"strength":1}]})");
  ASSERT_EQ(file.lights.size(), 1u);
  EXPECT_EQ(file.lights[0].direction, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(file.lights[0].direction_sigma, 0.0);
  EXPECT_TRUE(file.spheres.empty());
}

TEST(LightsFile, LeavesOutHighlightsThatNoSphereShows) {
  LightsFile file;
  file.lights.resize(2);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  file.highlights_px = {{{1.0, 2.0}, {nowhere, nowhere}}, {}};
  const auto again = read_text(lights_text(file));
  ASSERT_EQ(again.highlights_px.size(), 2u);
  EXPECT_EQ(again.highlights_px[0], (std::vector<Eigen::Vector2d>{{1.0, 2.0}}));
  for (const char* bad : {"[[[1, 2]]]", "[[1], []]", "[[[1, 2, 3]], []]", R"([[["a", 2]], []])"}) {
    EXPECT_THAT(error_of([&] {
                  read_text(R"({"hada":"lights/1","lights":[)"
                            R"({"image":"a.png","direction":[0,0,1],"strength":1},)"
                            R"({"image":"b.png","direction":[0,0,1],"strength":1}],)"
                            R"("highlights_px":)" +
                            std::string(bad) + "}");
                }),
                HasSubstr("highlights_px"))
        << bad;
  }
}

TEST(LightsFile, NamesTheKeyOfEveryFlaw) {
  const auto error = [](const std::string& light) {
    return error_of([&] { read_text(R"({"hada":"lights/1","lights":[)" + light + "]}"); });
  };
  EXPECT_THAT(error(""), HasSubstr("\"lights\" is empty"));
  EXPECT_THAT(error(R"({"image":"a","strength":1})"), HasSubstr("lights[0]: \"direction\""));
  EXPECT_THAT(error(R"({"image":"a","direction":[0,0,1]})"), HasSubstr("\"strength\" is missing"));
  EXPECT_THAT(error(R"({"image":"a","direction":[0,0,0],"strength":1})"), HasSubstr("no length"));
  EXPECT_THAT(error(R"({"image":"a","direction":[0,0,1],"strength":1,"power":2})"),
              HasSubstr("\"power\" is not a known key"));
  EXPECT_THAT(error(R"(3)"), HasSubstr("lights[0]: must be an object"));
  const std::string near = R"("image":"a","direction":[0,0,1],"strength":1,"position_)";
  EXPECT_THAT(error("{" + near + R"(mm":[0,0,9]},{)" + near + R"(px":[0,0,9]})"),
              HasSubstr("lights[1]: \"position_px\" mixes mm and px"));
  EXPECT_THAT(error("{" + near + R"(mm":[0,0,0]})"), HasSubstr("\"position_mm\" is the origin"));
}

TEST(LightsFile, RefusesErrorModesThatDoNotMatchTheLights) {
  const auto error = [](const std::string& modes) {
    return error_of([&] {
      read_text(R"({"hada":"lights/1","lights":[{"image":"a","direction":[0,0,1],"strength":1}],)"
                R"("error_modes":)" +
                modes + "}");
    });
  };
  EXPECT_EQ(error("[]"), "");
  EXPECT_EQ(error("[[[0.1,0,0]],[[0,0.1,0]]]"), "");
  for (const char* flawed : {"[[]]", "[[[1,2]]]", "[[[1,2,null]]]", "[[[1,2,3],[1,2,3]]]", "[1]",
                             "[[1,2,3]]", R"([{"a":[1,2,3]}])"}) {
    EXPECT_THAT(error(flawed), HasSubstr("\"error_modes\" must be a list of modes, each with 1"))
        << flawed;
  }
  EXPECT_THAT(error("3"), HasSubstr("\"error_modes\" must be a list"));
}

RC_GTEST_PROP(LightsFile, SurvivesCutsAndChangedBytes,
              (std::uint64_t seed, std::uint16_t place, char byte, bool cut)) {
  std::string text = lights_text(some_lights(seed));
  const std::size_t at = place % text.size();
  if (cut)
    text.resize(at);
  else
    text[at] = byte;
  error_of([&] { read_text(text); });
}

}  // namespace
}  // namespace hada
