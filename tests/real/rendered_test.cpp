#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"

namespace hada {
namespace {

// Captures made by another renderer: a figure and a half of what was reached guards it.
struct Scene {
  const char* name;
  double lights_deg;
  double normals_deg;
  double height_share;
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
  EXPECT_LT(score.height_share, GetParam().height_share);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Rendered,
                         ::testing::Values(Scene{"paper_wrinkled", 0.1, 0.1, 0.003},
                                           Scene{"paper_creased", 0.3, 0.3, 0.0015},
                                           Scene{"paper_glossy_printed", 0.3, 1.5, 0.25},
                                           Scene{"cloth_rough", 0.4, 2.5, 0.06},
                                           Scene{"near_light", 0.1, 0.4, 0.01}));

}  // namespace
}  // namespace hada
