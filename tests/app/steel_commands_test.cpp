#include <gtest/gtest.h>

#include "io/image_file.h"
#include "io/json.h"
#include "program.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

const std::string steel = R"({"hada": "material/1", "material": "forged", "parameters": {
  "sequence": "CCR", "kernel": "both", "levels": 70.0, "step": 5.0, "etch_mm": 0.002},
  "unit": "px", "seed": 4, "input": {"path": "", "hash": "", "pitch": 1.0, "size_px": [64, 96]}})";

TEST(Blade, IsMetalAsSmoothAsThePaperHasIt) {
  const TemporaryFolder scratch;
  put(scratch / "steel.json", steel);
  const auto made = answer("blade '" + (scratch / "steel.json").string() + "' --texture 256 -o '" +
                           (scratch / "out").string() + "'");
  EXPECT_EQ(made.code, 0) << made.err;
  const Json gltf = Json::parse(bytes_of(scratch / "out" / "blade.gltf"));
  const Json& metal = gltf.at("materials").at(0).at("pbrMetallicRoughness");
  // 1 is what glTF leaves out.
  EXPECT_EQ(metal.value("metallicFactor", 1.0), 1.0);
  EXPECT_NEAR(metal.at("roughnessFactor").get<double>(), 0.03, 1e-6);
  const Image colour = read_image(scratch / "out" / "colour.png").image;
  EXPECT_EQ(colour.cols(), 256);
  EXPECT_EQ(colour.rows(), 256 / 8);
  EXPECT_TRUE(fs::exists(scratch / "out" / "normal.png"));
  EXPECT_FALSE(fs::exists(scratch / "out" / "roughness.png"));
}

TEST(Blade, IsRougherWhereItIsHardened) {
  const TemporaryFolder scratch;
  put(scratch / "steel.json", steel);
  const auto made = answer("blade '" + (scratch / "steel.json").string() +
                           "' --texture 256 --hamon 0.4 -o '" + (scratch / "out").string() + "'");
  EXPECT_EQ(made.code, 0) << made.err;
  const Image rough = read_image(scratch / "out" / "roughness.png").image;
  // The back lies in row 0, the edge in the last.
  EXPECT_NEAR(rough.planes[1](rough.rows() - 1, 128), 0.22, 0.01);
  EXPECT_LT(rough.planes[1](0, 128), 0.05);
}

TEST(Blade, IsMadeOfForgedSteelAlone) {
  const TemporaryFolder scratch;
  put(scratch / "paper.json", R"({"hada": "material/1", "material": "wrinkle", "parameters": {
    "components": [{"amplitude_mm": 0.3, "long_mm": 6.0, "short_mm": 3.0, "angle_rad": 0.4}],
    "floor_mm4": 0.0}})");
  const auto made = answer("blade '" + (scratch / "paper.json").string() + "' -o '" +
                           (scratch / "out").string() + "'");
  EXPECT_EQ(made.code, 2);
  EXPECT_NE(made.err.find("a blade is made of forged steel"), std::string::npos) << made.err;
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST(Contact, PutsPicturesSideBySide) {
  const TemporaryFolder scratch;
  put(scratch / "steel.json", steel);
  const std::string file = "'" + (scratch / "steel.json").string() + "' ";
  const auto made = answer("contact " + file + file + file + "--columns 2 --width 64 -o '" +
                           (scratch / "sheet.png").string() + "'");
  EXPECT_EQ(made.code, 0) << made.err;
  const Image sheet = read_image(scratch / "sheet.png").image;
  // Two by two of 64 x 96 with a gap of 8; the fourth place stays white.
  ASSERT_EQ(sheet.cols(), 2 * 64 + 8);
  ASSERT_EQ(sheet.rows(), 2 * 96 + 8);
  for (int row = 96 + 8; row < sheet.rows(); ++row) {
    for (int col = 64 + 8; col < sheet.cols(); ++col) ASSERT_EQ(sheet.planes[0](row, col), 1.0f);
  }
  // All three are of one file and one seed.
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 64; ++col) {
      ASSERT_EQ(sheet.planes[0](row, col), sheet.planes[0](row, col + 64 + 8));
      ASSERT_EQ(sheet.planes[0](row, col), sheet.planes[0](row + 96 + 8, col));
    }
  }
}

TEST(Contact, WritesNothingIfAFileIsMissing) {
  const TemporaryFolder scratch;
  const auto made = answer("contact '" + (scratch / "missing.json").string() + "' -o '" +
                           (scratch / "sheet.png").string() + "'");
  EXPECT_EQ(made.code, 2);
  EXPECT_FALSE(fs::exists(scratch / "sheet.png"));
}

}  // namespace
}  // namespace hada
