#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "io/image_file.h"
#include "refusal.h"

namespace hada {
namespace {

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

  TemporaryFolder scratch;
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
  EXPECT_EQ(bytes_of(scratch / "file"), "in the way");
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

}  // namespace
}  // namespace hada
