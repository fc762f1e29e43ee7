#include "app/blender_script.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "app/material_file.h"
#include "io/image_file.h"
#include "program.h"
#include "tests/synth/slanted_stem.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 80, .cols = 96, .pitch = 0.25, .unit = Unit::mm};

/// The file of a stem that leans, tapers, bulges and turns in every way, cut aslant.
std::string slanted() {
  MaterialFile file;
  file.material = slanted_stem();
  return material_text(file);
}

TEST(BlenderScript, ListsANodeInEachRow) {
  const auto graph = wood_graph({}, extent, 1);
  const std::string text = blender_script(graph, {}, extent);
  const std::size_t from = text.find("NODES = ["), to = text.find("\n]\n", from);
  ASSERT_NE(to, std::string::npos);
  const auto rows =
      std::count(text.begin() + std::ptrdiff_t(from), text.begin() + std::ptrdiff_t(to), '\n');
  EXPECT_EQ(std::size_t(rows), graph.nodes.nodes().size());
  EXPECT_EQ(text.find("left out"), std::string::npos);
}

TEST(BlenderScript, IsForWoodOnly) {
  const TemporaryFolder scratch;
  MaterialFile knit;
  knit.material = material_named("knit");
  put(scratch / "knit.json", material_text(knit));
  const auto said = answer("synth " + (scratch / "knit.json").string() + " --blender -o " +
                           (scratch / "out").string());
  EXPECT_EQ(said.code, 2);
  EXPECT_NE(said.err.find("--blender is for wood"), std::string::npos) << said.err;
}

TEST(BlenderScript, DrawsTheCutThatHadaMakes) {
  if (std::system("blender --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "blender is not installed";
  const TemporaryFolder scratch;
  put(scratch / "wood.json", slanted());
  const std::string out = (scratch / "out").string();
  const auto said = answer("synth " + (scratch / "wood.json").string() +
                           " --size 96x80 --pitch 0.25 --blender -o " + out);
  ASSERT_EQ(said.code, 0) << said.err;
  const auto drawn = scratch / "slice.exr";
  const std::string draw = "blender -b --factory-startup -t 1 -P " + out + "/wood.py -- --render " +
                           drawn.string() + " > /dev/null 2>&1";
  ASSERT_EQ(std::system(draw.c_str()), 0);
  const Image theirs = read_image(drawn).image, ours = read_image(scratch / "out/albedo.exr").image;
  ASSERT_EQ(theirs.rows(), ours.rows());
  ASSERT_EQ(theirs.cols(), ours.cols());
  double sum = 0.0;
  for (std::size_t i = 0; i < ours.planes[0].size(); ++i)
    sum += std::abs(double(theirs.planes[0][i]) - double(ours.planes[0][i]));
  // A boundary of rings, 4 mm apart, is softened over a pixel of 0.25 mm here and over half of that
  // there: a quarter of the contrast, 0.36, on one pixel of sixteen at most.
  RecordProperty("mean_difference", std::to_string(sum / double(ours.planes[0].size())));
  EXPECT_LT(sum / double(ours.planes[0].size()), 0.01);
}

}  // namespace
}  // namespace hada
