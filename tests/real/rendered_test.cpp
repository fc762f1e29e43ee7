#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"

namespace hada {
namespace {

// Captures made by another renderer. Plain least squares knows nothing of sheen, of light thrown
// from sheet to sphere or of lights that are near (which tilt the normals of the last scene by tens
// of degrees): for the last three scenes the limits only guard what was reached.
struct Scene {
  const char* name;
  double lights_deg;
  double normals_deg;
};

class Rendered : public ::testing::TestWithParam<Scene> {};

TEST_P(Rendered, FindsEverySphereAndNoOther) {
  const auto scene = data_folder() / "rendered" / GetParam().name;
  if (!std::filesystem::exists(scene)) GTEST_SKIP() << "the scene is not in " << scene;
  const RenderedScore score = rendered(scene);
  EXPECT_EQ(score.spheres_found, score.spheres_true);
  EXPECT_EQ(score.spheres_false, 0);
  EXPECT_LT(score.lights_deg, GetParam().lights_deg);
  EXPECT_LT(score.normals_deg, GetParam().normals_deg);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Rendered,
                         ::testing::Values(Scene{"paper_wrinkled", 0.3, 0.3},
                                           Scene{"paper_creased", 0.5, 0.5},
                                           Scene{"paper_glossy_printed", 1.0, 5.5},
                                           Scene{"cloth_rough", 1.0, 5.0},
                                           Scene{"near_light", 25.0, 45.0}));

}  // namespace
}  // namespace hada
