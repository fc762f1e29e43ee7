#include "app/block_file.h"

#include <gtest/gtest.h>

#include "io/image_file.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

/// What is read of a block file that says `text`, in a folder with a picture.
BlockFile read_text(const std::string& text) {
  const TemporaryFolder folder;
  Image picture(20, 30, 3);
  for (auto& plane : picture.planes) std::fill(plane.begin(), plane.end(), 0.5f);
  write_integer_image(folder / "end.png", picture, 8);
  put(folder / "block.json", text);
  return read_block(folder / "block.json");
}

std::string complaint(const std::string& text) {
  return error_of([&] { read_text(text); });
}

TEST(BlockFile, PlacesFacesAndCuts) {
  const auto block = read_text(R"({"hada": "block/1",
    "faces": [{"picture": "end.png", "pitch_mm": 0.1},
              {"name": "side", "picture": "end.png", "pitch_mm": 0.2, "origin_mm": [5, 0, 0],
               "right": [0, 2, 0], "up": [0, 0, 1]}],
    "cuts": [{"name": "slanted", "size_px": [64, 32], "pitch_mm": 0.5}]})");
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
