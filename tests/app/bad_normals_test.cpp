#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "io/image_file.h"
#include "refusal.h"

namespace hada {
namespace {

// A normal map of a tilted plane and what goes with it, of which every test spoils one.
class BadNormals : public ::testing::Test {
 protected:
  void SetUp() override {
    Image map(20, 30, 3);
    for (float& x : map.planes[0]) x = 0.6f;
    for (float& z : map.planes[2]) z = 0.8f;
    write_exr(scratch / "normals.exr", map);
    write_integer_image(scratch / "mask.png", flat_picture(20, 30, 1.0f), 8);
    put(scratch / "K.txt", "500 0 15 0 500 10 0 0 1");
  }
  std::string file(const std::string& name) const { return (scratch / name).string(); }
  void expect_refused(const std::string& words) {
    expect_refusal("integrate " + words, scratch / "out");
  }

  TemporaryFolder scratch;
};

TEST_F(BadNormals, GoodOnesBecomeASurface) {
  const Answer said = answer("integrate " + file("normals.exr") + " --mask " + file("mask.png") +
                             " --intrinsics " + file("K.txt") + " --pitch 0.1 -o " + file("out"));
  EXPECT_EQ(said.code, 0) << said.err;
  for (const char* name : {"surface.json", "height.exr", "depth.exr", "mask.png", "normal.exr"}) {
    EXPECT_TRUE(fs::exists(scratch / "out" / name)) << name;
  }
  // A plane that falls by 0.75 to the right, seen from straight above.
  const Answer flat =
      answer("integrate " + file("normals.exr") + " --pitch 0.1 -o " + file("flat"));
  EXPECT_EQ(flat.code, 0) << flat.err;
  const Grid<float> height = read_image(scratch / "flat" / "height.exr").image.planes[0];
  EXPECT_NEAR(height(5, 29) - height(5, 0), -0.75f * 2.9f, 1e-4f);
}

TEST_F(BadNormals, WhoseSigmaIsKnownGiveThatOfTheHeight) {
  const std::string words = "integrate " + file("normals.exr") + " --normal-sigma ";
  ASSERT_EQ(answer(words + "0.5 -o " + file("even")).code, 0);
  const auto sigma = [&](const char* folder) {
    return read_image(scratch / folder / "height_sigma.exr").image.planes[0](10, 15);
  };
  EXPECT_GT(sigma("even"), 0.0f);
  // A map of the same in radians says the same; twice as much, twice as much.
  write_exr(scratch / "sigma.exr",
            flat_picture(20, 30, float(2.0 * 0.5 * std::numbers::pi / 180.0)));
  ASSERT_EQ(answer(words + file("sigma.exr") + " -o " + file("map")).code, 0);
  EXPECT_NEAR(sigma("map") / sigma("even"), 2.0, 1e-3);
  for (const std::string bad : {"0", "-1", "1e9", "nan", "nothing.exr"}) {
    expect_refused(file("normals.exr") + " --normal-sigma " + bad);
  }
  Image spoilt = flat_picture(20, 30, 0.1f);
  spoilt.planes[0](3, 4) = std::nanf("");
  write_exr(scratch / "spoilt.exr", spoilt);
  expect_refused(file("normals.exr") + " --normal-sigma " + file("spoilt.exr"));
}

TEST_F(BadNormals, AreTakenHoweverTheirMatrixIsWritten) {
  put(scratch / "L.txt", "[[500, 0, 15], [0, 500, 10], [0, 0, 1]]");
  const Answer said = answer("integrate " + file("normals.exr") + " --intrinsics " + file("L.txt") +
                             " -o " + file("out"));
  EXPECT_EQ(said.code, 0) << said.err;
}

TEST_F(BadNormals, SayWhatOfThemIsLeftOut) {
  Image weights = flat_picture(20, 30, 1.0f);
  for (int col = 0; col < 30; ++col) weights.planes[0](19, col) = -1.0f;
  write_exr(scratch / "weights.exr", weights);
  Image mask = flat_picture(20, 30, 1.0f);
  for (int row = 0; row < 20; ++row) mask.planes[0](row, 12) = 0.0f;
  write_integer_image(scratch / "parts.png", mask, 8);
  const Answer said = answer("integrate " + file("normals.exr") + " --mask " + file("parts.png") +
                             " --weights " + file("weights.exr") + " -o " + file("out"));
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_NE(said.out.find("5 % of the pixels have a weight"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("2 separate regions"), std::string::npos) << said.out;
}

TEST_F(BadNormals, SayWhatTheyHardlyCanMean) {
  const auto said = [&](const std::string& words) {
    return answer("integrate " + words + " -o " + file("out")).out;
  };
  const std::string good = said(file("normals.exr") + " --intrinsics " + file("K.txt"));
  EXPECT_EQ(good.find("note"), std::string::npos) << good;
  put(scratch / "mm.txt", "5 0 15 0 5 10 0 0 1");  // no focal length in pixels
  const std::string wide = said(file("normals.exr") + " --intrinsics " + file("mm.txt"));
  EXPECT_NE(wide.find("degrees off its axis"), std::string::npos) << wide;
  Image map(20, 30, 3);
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 30; ++col) {
      map.planes[0](row, col) = 0.6f;
      map.planes[2](row, col) = row < 5 ? -0.8f : 0.8f;
    }
  }
  write_exr(scratch / "away.exr", map);
  EXPECT_NE(said(file("away.exr")).find("25 % of the normals look away"), std::string::npos);
  for (float& z : map.planes[2]) z = 1.1f;
  write_exr(scratch / "long.exr", map);
  EXPECT_NE(said(file("long.exr")).find("no unit vectors"), std::string::npos);
}

TEST_F(BadNormals, WhoseMaskIsDarkAreToldHowDark) {
  write_integer_image(scratch / "ones.png", flat_picture(20, 30, 1.0f / 255.0f), 8);
  const Answer said = answer("integrate " + file("normals.exr") + " --mask " + file("ones.png") +
                             " -o " + file("out"));
  EXPECT_EQ(said.code, 2);
  EXPECT_NE(said.err.find("brightest is 0.0039 of white"), std::string::npos) << said.err;
}

TEST_F(BadNormals, MapsOnTheDiskGiveTheSameBytes) {
  Image map(700, 900, 3);
  for (std::size_t i = 0; i < map.planes[0].size(); ++i) {
    map.planes[0][i] = 0.3f * float(std::sin(0.001 * double(i)));
    map.planes[2][i] = i % 97 == 0 ? 0.0f : 0.95f;
  }
  write_exr(scratch / "large.exr", map);
  put(scratch / "L.txt", "1500 0 450 0 1500 350 0 0 1");
  for (const char* where : {"ram", "disk"}) {
    const Answer said = answer("integrate " + file("large.exr") + " --intrinsics " + file("L.txt") +
                               " --memory " + where + " -o " + file(where));
    EXPECT_EQ(said.code, 0) << said.err;
  }
  for (const auto& entry : fs::directory_iterator(scratch / "ram")) {
    const auto name = entry.path().filename();
    EXPECT_EQ(bytes_of(entry.path()), bytes_of(scratch / "disk" / name)) << name;
  }
  expect_refused(file("large.exr") + " --memory disk --jumps allowed");
}

TEST_F(BadNormals, HeightsKnownBeforeTakeTheLongWaves) {
  // The plane of the normals, seen twice as coarse, but it falls twice as much.
  Image prior(10, 15, 1);
  for (int row = 0; row < 10; ++row) {
    for (int col = 0; col < 15; ++col) prior.planes[0](row, col) = -1.5f * 0.2f * float(col);
  }
  prior.planes[0](2, 3) = std::nanf("");
  write_exr(scratch / "prior.exr", prior);
  const std::string with_prior =
      "integrate " + file("normals.exr") + " --prior " + file("prior.exr");
  const Answer said = answer(with_prior + " --pitch 0.1 --cutoff 1 -o " + file("known"));
  EXPECT_EQ(said.code, 0) << said.err;
  const Grid<float> height = read_image(scratch / "known" / "height.exr").image.planes[0];
  // Beyond the middles of the outermost pixels of the prior nothing more is known of it.
  EXPECT_NEAR(height(5, 24) - height(5, 5), -1.5f * 1.9f, 0.05f);
  const std::string description = bytes_of(scratch / "known" / "surface.json");
  EXPECT_NE(description.find("\"levelling\": \"prior\""), std::string::npos);
  EXPECT_NE(description.find("\"levelling_cutoff\": 1"), std::string::npos);
  EXPECT_EQ(answer("measure " + file("known")).code, 0);

  EXPECT_EQ(answer(with_prior + " --pitch 0.1 --cutoff 1e200 -o " + file("long")).code, 0);
  EXPECT_EQ(answer("measure " + file("long")).code, 0);
  expect_refused(file("normals.exr") + " --pitch 0.2 --prior " + file("known"));  // half as large
  const Answer folder = answer("integrate " + file("normals.exr") + " --prior " + file("known") +
                               " -o " + file("px"));
  EXPECT_EQ(folder.code, 2);  // in mm, but the surface in pixels
}

TEST_F(BadNormals, PriorsThatSayNothingAreRefused) {
  // Spots of a finer map count for the pixels that they lie in.
  Image spots(40, 60, 1);
  for (float& height : spots.planes[0]) height = std::nanf("");
  spots.planes[0](3, 7) = 1.0f;
  spots.planes[0](30, 41) = -1.0f;
  write_exr(scratch / "spots.exr", spots);
  EXPECT_EQ(answer("integrate " + file("normals.exr") + " --prior " + file("spots.exr") + " -o " +
                   file("spotted"))
                .code,
            0);
  write_exr(scratch / "prior.exr", Image(10, 15, 1));
  expect_refused(file("normals.exr") + " --cutoff 1");
  expect_refused(file("normals.exr") + " --pitch 1e-300 --cutoff 1e200 --prior " +
                 file("prior.exr"));
  for (float& height : spots.planes[0]) height = std::nanf("");
  write_exr(scratch / "nothing.exr", spots);
  expect_refused(file("normals.exr") + " --prior " + file("nothing.exr"));
  expect_refused(file("normals.exr") + " --prior " + file("none.exr"));
  expect_refused(file("normals.exr") + " --prior " + file("mask.png"));
  expect_refused(file("normals.exr") + " --levelling plane --prior " + file("prior.exr"));
  expect_refused(file("normals.exr") + " --pitch 0.1 --cutoff 0.2 --prior " + file("prior.exr"));
  write_exr(scratch / "square.exr", Image(9, 9, 1));
  expect_refused(file("normals.exr") + " --prior " + file("square.exr"));
}

TEST_F(BadNormals, MissingAndBrokenFilesAreSaid) {
  expect_refused(file("none.exr"));
  expect_refused(file("normals.exr") + " --mask " + file("none.png"));
  expect_refused(file("normals.exr") + " --intrinsics " + file("none.txt"));
  expect_refused(file("normals.exr") + " --weights " + file("none.exr"));
  put(scratch / "broken.exr", "no picture");
  expect_refused(file("broken.exr"));
  put(scratch / "K.txt", "500 0 15 0 500");
  expect_refused(file("normals.exr") + " --intrinsics " + file("K.txt"));
}

TEST_F(BadNormals, WhatIsNoNormalMapIsSaid) {
  expect_refused(file("mask.png"));  // one channel
  write_exr(scratch / "zero.exr", Image(20, 30, 3));
  expect_refused(file("zero.exr"));
}

TEST_F(BadNormals, AnotherSizeAndAnEmptyMaskAreSaid) {
  write_integer_image(scratch / "small.png", flat_picture(10, 30, 1.0f), 8);
  expect_refused(file("normals.exr") + " --mask " + file("small.png"));
  expect_refused(file("normals.exr") + " --weights " + file("small.png"));
  write_integer_image(scratch / "empty.png", flat_picture(20, 30, 0.0f), 8);
  expect_refused(file("normals.exr") + " --mask " + file("empty.png"));
  expect_refused(file("normals.exr") + " --weights " + file("empty.png"));
}

TEST_F(BadNormals, WordsThatDoNotGoTogetherAreSaid) {
  expect_refused(file("normals.exr") + " --memory disk --jumps allowed");
  expect_refused(file("normals.exr") + " --jumps sometimes");
  expect_refused(file("normals.exr") + " --pitch -1");
}

}  // namespace
}  // namespace hada
