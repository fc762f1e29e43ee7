#include "app/block_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/image_file.h"

namespace hada {
namespace {

/// A folder with a picture, and a block file that says `text`.
std::filesystem::path block_that_says(const std::string& text) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "hada_block_file";
  std::filesystem::create_directories(folder);
  Image picture(20, 30, 3);
  for (auto& plane : picture.planes) std::fill(plane.begin(), plane.end(), 0.5f);
  write_integer_image(folder / "end.png", picture, 8);
  std::ofstream(folder / "block.json") << text;
  return folder / "block.json";
}

/// What is said of a file that cannot be read.
std::string complaint(const std::string& text) {
  try {
    read_block(block_that_says(text));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(BlockFile, PlacesFacesAndCuts) {
  const auto block = read_block(block_that_says(R"({"hada": "block/1",
    "faces": [{"picture": "end.png", "pitch_mm": 0.1},
              {"name": "side", "picture": "end.png", "pitch_mm": 0.2, "origin_mm": [5, 0, 0],
               "right": [0, 2, 0], "up": [0, 0, 1]}],
    "cuts": [{"name": "slanted", "size_px": [64, 32], "pitch_mm": 0.5}]})"));
  ASSERT_EQ(block.faces.size(), 2u);
  EXPECT_EQ(block.faces[0].name, "end");
  EXPECT_EQ(block.faces[0].cut.towards_eye(), (StemVector{0.0, 0.0, 1.0}));
  EXPECT_EQ(block.faces[1].name, "side");
  EXPECT_EQ(block.faces[1].cut.at(1.0, 2.0), (StemVector{5.0, 1.0, 2.0}));
  EXPECT_EQ(block.faces[1].surface.extent.pitch, 0.2);
  ASSERT_EQ(block.cuts.size(), 1u);
  EXPECT_EQ(block.cuts[0].extent.rows, 32);
  EXPECT_EQ(block.cuts[0].extent.cols, 64);
}

TEST(BlockFile, SaysWhatIsWrong) {
  const auto one = [](const std::string& rest) {
    return R"({"hada": "block/1", "faces": [{"name": "a", "picture": "end.png")" + rest;
  };
  EXPECT_NE(complaint(R"({"hada": "block/1", "faces": []})").find("faces"), std::string::npos);
  EXPECT_NE(complaint(one(R"(, "pitch_mm": 0}]})")).find("pitch_mm"), std::string::npos);
  EXPECT_NE(complaint(one(R"(, "colour": 1}]})")).find("colour"), std::string::npos);
  EXPECT_NE(complaint(one(R"(}, {"name": "a", "picture": "end.png"}]})")).find("\"a\""),
            std::string::npos);
  EXPECT_NE(complaint(one(R"(}], "cuts": [{"name": "b", "size_px": [4, 64]}]})")).find("size_px"),
            std::string::npos);
}

}  // namespace
}  // namespace hada
