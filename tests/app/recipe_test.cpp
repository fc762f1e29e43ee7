#include "app/recipe.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

const char* const complete = R"({
  "hada": "recipe/1",
  "name": "two lights",
  "material": {"material": "wrinkle", "parameters": {
    "components": [{"amplitude_mm": 0.2, "long_mm": 8, "short_mm": 3, "angle_rad": 0.5}],
    "floor_mm4": 0}},
  "sheet": {"width_mm": 40, "height_mm": 30, "seed": 5},
  "rig": {"pitch_mm": 0.2, "rows": 200, "cols": 300, "oversampling": 2,
    "lights": [{"slant_deg": 30, "azimuth_deg": 90, "strength": 1.1},
               {"direction": [3, 0, 4], "strength": [1, 0.9, 0.8]}],
    "light_diameter_deg": 3, "bits": 8, "seed": 9,
    "spheres": [{"kind": "chrome", "place_mm": [10, -5], "diameter_mm": 12, "albedo": 0.8}]}
})";

// Reads `text` as a recipe, from a file of its own.
Recipe read_text(const std::string& text) {
  const TemporaryFolder folder;
  put(folder / "recipe.json", text);
  return read_recipe(folder / "recipe.json");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string complaint(const std::string& text) {
  return error_of([&] { read_text(text); });
}

TEST(Recipe, SaysEverythingThatItsFileSays) {
  const Recipe recipe = read_text(complete);
  EXPECT_EQ(recipe.name, "two lights");
  EXPECT_EQ(recipe.sheet, (Extent{300, 400, 0.1, Unit::mm}));
  EXPECT_EQ(recipe.sheet_seed, 5u);
  EXPECT_EQ(std::get<Wrinkle<>>(recipe.material).components.at(0).long_mm, 8.0);
  const Rig& rig = recipe.rig;
  EXPECT_EQ(rig.rows, 200);
  EXPECT_EQ(rig.cols, 300);
  EXPECT_EQ(rig.bits, 8);
  EXPECT_EQ(rig.seed, 9u);
  EXPECT_NEAR(rig.light_diameter, 3.0 * degree, 1e-15);
  ASSERT_EQ(rig.lights.size(), 2u);
  EXPECT_LT((rig.lights[0].direction - Eigen::Vector3d(0.0, 0.5, std::sqrt(0.75))).norm(), 1e-12);
  EXPECT_EQ(rig.lights[0].strength, Eigen::Vector3d::Constant(1.1));
  EXPECT_LT((rig.lights[1].direction - Eigen::Vector3d(0.6, 0.0, 0.8)).norm(), 1e-12);
  EXPECT_EQ(rig.lights[1].strength, Eigen::Vector3d(1.0, 0.9, 0.8));
  ASSERT_EQ(rig.spheres.size(), 1u);
  EXPECT_EQ(rig.spheres[0].kind, SphereKind::chrome);
  EXPECT_EQ(rig.spheres[0].place, Eigen::Vector2d(10.0, -5.0));
  EXPECT_EQ(rig.read_noise, Rig{}.read_noise);
}

TEST(Recipe, NamesThePlaceOfAnUnknownKey) {
  const std::string text = complaint(replaced(complete, "\"bits\"", "\"bitz\""));
  EXPECT_NE(text.find("\"bitz\" is not a known key"), std::string::npos) << text;
  EXPECT_NE(text.find(".json"), std::string::npos) << text;
}

TEST(Recipe, RefusesWhatNoRigHas) {
  EXPECT_NE(complaint(replaced(complete, "\"bits\": 8", "\"bits\": 12")), "");
  EXPECT_NE(complaint(replaced(complete, "\"pitch_mm\": 0.2", "\"pitch_mm\": 0")), "");
  EXPECT_NE(complaint(replaced(complete, "\"chrome\"", "\"glass\"")), "");
  EXPECT_NE(complaint(replaced(complete, "[3, 0, 4]", "[3, 0, -4]")), "");
  EXPECT_NE(complaint(replaced(complete, "\"oversampling\": 2", "\"oversampling\": 64")), "");
  EXPECT_NE(complaint(replaced(complete, "\"rows\": 200", "\"rows\": 2.5")), "");
  EXPECT_NE(complaint(replaced(complete, "\"wrinkle\"", "\"wrinkled\"")), "");
  EXPECT_NE(complaint(replaced(complete, "recipe/1", "recipe/2")), "");
}

TEST(Recipe, OfTheDemoCanBePhotographed) {
  const Recipe recipe = read_recipe(HADA_SOURCE_DIR "/data_synthetic/sheet_and_spheres.json");
  EXPECT_EQ(recipe.sheet, (Extent{2600, 2600, 0.05, Unit::mm}));
  ASSERT_EQ(recipe.rig.lights.size(), 8u);
  double strength = 0.0;
  for (const Light& light : recipe.rig.lights) {
    const double slant = std::acos(light.direction.z()) / degree;
    EXPECT_GE(slant, 25.0 - 1e-9);
    EXPECT_LE(slant, 50.0 + 1e-9);
    strength += light.strength.x();
  }
  EXPECT_NEAR(strength, 8.0, 1e-12);
  ASSERT_EQ(recipe.rig.spheres.size(), 2u);
}

}  // namespace
}  // namespace hada
