#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "core/image.h"
#include "io/image_file.h"
#include "program.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

// One sentence, exit code 2, and nothing new on the disk.
void expect_refusal(const std::string& words, const fs::path& out) {
  const Answer said = answer(words + " -o " + out.string());
  EXPECT_EQ(said.code, 2) << words;
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
  EXPECT_EQ(said.err.rfind("hada: ", 0), 0u) << said.err;
  EXPECT_TRUE(said.out.empty()) << said.out;
  EXPECT_FALSE(fs::exists(out)) << out;
}

Image flat_picture(int rows, int cols, float value) {
  Image image(rows, cols, 1);
  std::fill(image.planes[0].begin(), image.planes[0].end(), value);
  return image;
}

class BadInput : public ::testing::Test {
 protected:
  // Every test spoils a good capture in one way.
  void SetUp() override { ASSERT_EQ(make_capture(capture).code, 0); }
  void expect_refused() { expect_refusal("reconstruct " + capture.string(), scratch / "out"); }
  void expect_refused_everywhere() {
    expect_refused();
    expect_refusal("run " + capture.string(), scratch / "run");
    expect_refusal("calibrate " + capture.string(), scratch / "lights.json");
  }
  fs::path picture(int number) const {
    return capture / ("light_0" + std::to_string(number) + ".png");
  }

  Scratch scratch;
  fs::path capture = scratch / "capture";
};

TEST_F(BadInput, NoImagesIsSaid) {
  fs::remove_all(capture);
  fs::create_directories(capture);
  expect_refused_everywhere();
}

TEST_F(BadInput, MissingFolderIsSaid) {
  fs::remove_all(capture);
  expect_refused_everywhere();
}

TEST_F(BadInput, TwoLightsAreTooFew) {
  fs::remove(capture / "capture.json");
  fs::remove(picture(3));
  fs::remove(picture(4));
  expect_refused();
}

TEST_F(BadInput, MixedSizesAreSaid) {
  write_integer_image(picture(2), flat_picture(50, 60, 0.5f), 16);
  expect_refused_everywhere();
}

TEST_F(BadInput, TruncatedFileIsSaid) {
  fs::resize_file(picture(2), fs::file_size(picture(2)) / 2);
  expect_refused_everywhere();
}

TEST_F(BadInput, TextNamedPngIsSaid) {
  put(picture(2), "this is not a picture\n");
  expect_refused_everywhere();
}

TEST_F(BadInput, NotANumberInAnExrIsSaid) {
  fs::remove(capture / "capture.json");
  Image image = flat_picture(110, 180, 0.5f);
  image.planes[0](3, 4) = std::numeric_limits<float>::quiet_NaN();
  write_exr(capture / "light_05.exr", image);
  expect_refused_everywhere();
}

TEST_F(BadInput, LightsInAPlaneAreSaid) {
  put(scratch / "plane.json", R"({"hada": "lights/1", "lights": [
    {"image": "light_01.png", "direction": [0.5, 0.0, 0.86], "strength": 1.0},
    {"image": "light_02.png", "direction": [0.2, 0.0, 0.97], "strength": 1.0},
    {"image": "light_03.png", "direction": [-0.2, 0.0, 0.97], "strength": 1.0},
    {"image": "light_04.png", "direction": [-0.5, 0.0, 0.86], "strength": 1.0}]})");
  expect_refusal(
      "reconstruct " + capture.string() + " --lights " + (scratch / "plane.json").string(),
      scratch / "out");
}

TEST_F(BadInput, NoSphereIsSaid) {
  for (int k = 1; k <= 4; ++k) {
    write_integer_image(picture(k), flat_picture(110, 180, 0.2f + 0.05f * float(k)), 16);
  }
  expect_refused_everywhere();
}

TEST_F(BadInput, SphereCutOffByTheFrameIsSaid) {
  put(scratch / "cut.json", small_recipe(62.0));  // its right edge lies 8 mm outside
  fs::remove_all(capture);
  const Answer made =
      answer("photograph " + (scratch / "cut.json").string() + " -o " + capture.string());
  // Either nobody photographs such a thing, or nobody measures with it.
  if (made.code == 0) expect_refused_everywhere();
}

TEST_F(BadInput, AllBlackIsSaid) {
  for (int k = 1; k <= 4; ++k) {
    write_integer_image(picture(k), flat_picture(110, 180, 0.0f), 16);
  }
  expect_refused_everywhere();
}

TEST_F(BadInput, AllWhiteIsSaid) {
  for (int k = 1; k <= 4; ++k) {
    write_integer_image(picture(k), flat_picture(110, 180, 1.0f), 16);
  }
  expect_refused_everywhere();
}

TEST_F(BadInput, UnknownKeyIsNamed) {
  put(capture / "capture.json", R"({"hada": "capture/1", "pich_mm": 0.2})");
  expect_refused_everywhere();
  const Answer said = answer("calibrate " + capture.string() + " -o " + (scratch / "l").string());
  EXPECT_NE(said.err.find("pich_mm"), std::string::npos);
  put(scratch / "material.json", R"({"hada": "material/1", "material": "wrinkle", "colour": 3,
    "parameters": {"components": [], "floor_mm4": 0}})");
  expect_refusal("synth " + (scratch / "material.json").string(), scratch / "synth");
}

TEST_F(BadInput, OnePixelIsSaid) {
  for (int k = 1; k <= 4; ++k) write_integer_image(picture(k), flat_picture(1, 1, 0.5f), 16);
  expect_refused_everywhere();
  expect_refusal("measure " + picture(1).string(), scratch / "measured");
  expect_refusal("fit wrinkle " + picture(1).string(), scratch / "m.json");
}

TEST_F(BadInput, UnwritableOutputIsSaid) {
  put(scratch / "file", "in the way");
  const fs::path out = scratch / "file" / "deeper";
  expect_refusal("reconstruct " + capture.string(), out);
  expect_refusal("run " + capture.string(), out);
  EXPECT_EQ(text_of(scratch / "file"), "in the way");
}

TEST_F(BadInput, UnknownMaterialIsSaidWithTheKnownOnes) {
  expect_refusal("run " + capture.string() + " --material paper", scratch / "out");
  const Answer said = answer("fit paper " + capture.string());
  EXPECT_NE(said.err.find("wrinkle"), std::string::npos) << said.err;
}

// Ctrl-C at many moments: the work is whole or it is not there.
TEST_F(BadInput, InterruptLeavesNothingHalfWritten) {
  const fs::path out = scratch / "out";
  for (const int delay_ms : {5, 40, 120, 250, 400, 550}) {
    fs::remove_all(out);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      execl(HADA_PROGRAM, HADA_PROGRAM, "run", capture.c_str(), "-o", out.c_str(), "--quiet",
            static_cast<char*>(nullptr));
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    const bool was_finished = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (was_finished) {
      EXPECT_TRUE(fs::exists(out / "report.html"));
      continue;
    }
    // Before the program has said what an interrupt means, the system's own way holds.
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    EXPECT_EQ(code, 130) << delay_ms;
    EXPECT_FALSE(fs::exists(out)) << delay_ms;
    for (const auto& entry : fs::directory_iterator(scratch.path())) {
      EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
    }
  }
}

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

  Scratch scratch;
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
  write_exr(scratch / "sigma.exr", flat_picture(20, 30, float(2.0 * 0.5 * M_PI / 180.0)));
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
    EXPECT_EQ(text_of(entry.path()), text_of(scratch / "disk" / name)) << name;
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
  const std::string description = text_of(scratch / "known" / "surface.json");
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
  expect_refused(file("normals.exr") + " --weights " + file("mask.png") + " --jumps allowed");
  expect_refused(file("normals.exr") + " --jumps sometimes");
  expect_refused(file("normals.exr") + " --pitch -1");
}

}  // namespace
}  // namespace hada
