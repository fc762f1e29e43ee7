#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "app/material_file.h"
#include "io/json.h"
#include "io/lights_file.h"
#include "program.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
    }
  }
  return files;
}

class Outputs : public ::testing::Test {
 protected:
  // One capture and one run serve every test; one component is fitted fastest.
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<TemporaryFolder>();
    ASSERT_EQ(make_capture(*scratch_ / "capture").code, 0);
    ASSERT_EQ(run_into("one", "--threads 1").code, 0);
  }
  static void TearDownTestSuite() { scratch_.reset(); }

  static fs::path path(const std::string& name) { return *scratch_ / name; }
  static std::string at(const std::string& name) { return path(name).string(); }
  static Answer run_into(const std::string& out, const std::string& words) {
    return answer("run " + at("capture") + " --components 1 -o " + at(out) + " " + words);
  }

 private:
  static std::unique_ptr<TemporaryFolder> scratch_;
};

std::unique_ptr<TemporaryFolder> Outputs::scratch_;

TEST_F(Outputs, AreTheSameBytesWithOneAndWithTwoThreads) {
  const Answer said = run_into("two", "--threads 2 --quiet");
  ASSERT_EQ(said.code, 0);
  EXPECT_EQ(said.out, "");
  const auto one = contents(path("one"));
  const auto two = contents(path("two"));
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [name, bytes] : one) EXPECT_TRUE(two.at(name) == bytes) << name;
}

TEST_F(Outputs, OfOneCalibrationServeAnotherCommand) {
  ASSERT_EQ(answer("calibrate " + at("capture") + " -o " + at("once.json")).code, 0);
  EXPECT_NE(bytes_of(path("once.json")).find("\"error_modes\""), std::string::npos);
  const std::string words = "reconstruct " + at("capture") + " -o ";
  ASSERT_EQ(answer(words + at("itself")).code, 0);
  const Answer reused = answer(words + at("reused") + " --lights " + at("once.json"));
  ASSERT_EQ(reused.code, 0);
  EXPECT_NE(reused.out.find("4 distant lights taken from once.json, read off 1 sphere (matte)\n"),
            std::string::npos)
      << reused.out;
  const LightsFile one = read_lights(path("itself") / "lights.json");
  const LightsFile two = read_lights(path("reused") / "lights.json");
  ASSERT_EQ(one.errors.size(), two.errors.size());
  ASSERT_FALSE(one.errors.empty());
  for (std::size_t k = 0; k < one.lights.size(); ++k) {
    // Normalised once more: a few roundings of numbers below 2.
    EXPECT_LT((one.lights[k].direction - two.lights[k].direction).norm(), 1e-15);
    EXPECT_LT((one.lights[k].strength - two.lights[k].strength).norm(), 1e-15);
    EXPECT_LT((one.errors[0][k] - two.errors[0][k]).norm(), 1e-15);
  }
  EXPECT_EQ(one.spheres.size(), two.spheres.size());
}

TEST_F(Outputs, OfACalibrationMayBeALightPositionFile) {
  const Answer said = answer("calibrate " + at("capture") + " -o " + at("dome.lp"));
  ASSERT_EQ(said.code, 0);
  EXPECT_NE(said.out.find("note: A .lp file holds directions only"), std::string::npos) << said.out;
  EXPECT_EQ(bytes_of(path("dome.lp")).rfind("4\nlight_01.png 0.", 0), 0u);
  EXPECT_EQ(
      answer("reconstruct " + at("capture") + " --lights " + at("dome.lp") + " -o " + at("by_lp"))
          .code,
      0);
}

TEST_F(Outputs, OfTheWholePathAreTheOnesPromised) {
  for (const std::string name : {"lights.json", "measure.json", "material.json", "report.html",
                                 "surface/surface.json", "surface/height.exr", "surface/normal.exr",
                                 "surface/height.png", "surface/lights.json", "synth/height.exr"}) {
    EXPECT_TRUE(fs::exists(path("one") / name)) << name;
  }
}

TEST_F(Outputs, ReportRefersToNothingOutsideItself) {
  const std::string report = bytes_of(path("one") / "report.html");
  for (const std::string outside : {"http:", "https:", "//cdn", "@import", "<script", "<link"}) {
    EXPECT_EQ(report.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(report.find(">nan"), std::string::npos);  // no number went missing
}

TEST_F(Outputs, SayWhatBecameOfEverySample) {
  const Answer said = answer("reconstruct " + at("capture") + " --labels --json -o " + at("told"));
  ASSERT_EQ(said.code, 0) << said.err;
  for (const char* name : {"albedo_sigma.exr", "inliers.png", "labels/01.png", "labels/04.png"}) {
    EXPECT_TRUE(fs::exists(path("told") / name)) << name;
  }
  const Json samples = Json::parse(said.out)["samples"];
  double all = 0.0;
  for (const auto& [label, share] : samples.items()) all += share.get<double>();
  EXPECT_NEAR(all, 1.0, 1e-9);
  EXPECT_GT(samples["lit"].get<double>(), 0.9);
  // A folder without them says nothing of them.
  EXPECT_FALSE(fs::exists(path("one") / "surface" / "labels"));
}

TEST_F(Outputs, OfOneCommandAreTheInputOfTheNext) {
  ASSERT_EQ(answer("calibrate " + at("capture") + " -o " + at("lights.json")).code, 0);
  ASSERT_EQ(answer("reconstruct " + at("capture") + " --lights " + at("lights.json") + " -o " +
                   at("surface"))
                .code,
            0);
  ASSERT_EQ(answer("measure " + at("surface") + " -o " + at("measured")).code, 0);
  EXPECT_TRUE(fs::exists(path("measured") / "spectrum.png"));
  ASSERT_EQ(
      answer("fit wrinkle " + at("surface") + " --components 1 -o " + at("material.json")).code, 0);
  ASSERT_EQ(answer("synth " + at("material.json") + " --size 64x48 --seed 5 -o " + at("more")).code,
            0);
  ASSERT_EQ(
      answer("compare " + at("surface") + " " + at("capture") + "/truth -o " + at("both")).code, 0);
  EXPECT_TRUE(fs::exists(path("both") / "compare.html"));
  // A plain picture is measured, and fitted by its brightness.
  const std::string picture = at("capture") + "/light_01.png";
  EXPECT_EQ(answer("measure " + picture + " --pitch 0.8 --json").code, 0);
  EXPECT_EQ(
      answer("fit wrinkle " + picture + " --pitch 0.8 --components 1 -o " + at("bright.json")).code,
      0);
}

// A painted sheet; `colour` is what its file says of its mean albedo.
std::string painted_file(const std::string& colour) {
  return R"({"hada": "material/1", "material": "wrinkle", "unit": "px", "parameters": {"components":
         [{"amplitude_mm": 0.08, "long_mm": 4.0, "short_mm": 1.5, "angle_rad": 0.6}],
         "floor_mm4": 1e-5}, "mean_albedo": )" +
         colour + "}";
}

// Pictures are fitted to what comes back as a picture: same hue, same brightness, no height.
TEST_F(Outputs, OfAFitToAPictureAreAPicture) {
  put(path("cloth.json"), painted_file("[0.4, 0.3, 0.1]"));
  ASSERT_EQ(
      answer("synth " + at("cloth.json") + " --pitch 1 --size 160x128 -o " + at("cloth")).code, 0);
  EXPECT_TRUE(fs::exists(path("cloth") / "albedo.exr"));
  EXPECT_FALSE(fs::exists(path("cloth") / "height.exr"));
  EXPECT_FALSE(fs::exists(path("cloth") / "roughness.png"));
  ASSERT_EQ(answer("fit wrinkle " + at("cloth") + " --components 1 -o " + at("found.json")).code,
            0);
  const MaterialFile found = read_material(path("found.json"));
  ASSERT_EQ(found.mean_albedo.size(), 3u);
  // The field of 12 x 12 independent places has a mean of 0.007 of its own.
  EXPECT_NEAR(found.mean_albedo[0], 0.4, 0.02);
  EXPECT_NEAR(found.mean_albedo[1] / found.mean_albedo[0], 0.75, 1e-4);
  EXPECT_NEAR(found.mean_albedo[2] / found.mean_albedo[0], 0.25, 1e-4);
  const auto& ripple = std::get<Wrinkle<>>(found.material).components.front();
  const auto& sigma = std::get<Wrinkle<>>(*found.sigma).components.front();
  EXPECT_NEAR(ripple.amplitude_mm, 0.08, 4.0 * sigma.amplitude_mm);
  EXPECT_NEAR(ripple.long_mm, 4.0, 4.0 * sigma.long_mm);
  EXPECT_NEAR(ripple.angle_rad, 0.6, 4.0 * sigma.angle_rad);
  ASSERT_EQ(answer("synth " + at("found.json") + " --seed 9 -o " + at("again")).code, 0);
  const Answer compared =
      answer("compare " + at("cloth") + " " + at("again") + " -o " + at("alike"));
  EXPECT_EQ(compared.code, 0) << compared.err;
}

TEST_F(Outputs, RefuseAColourThatIsNone) {
  for (const std::string colour :
       {"[0.1, 0.2]", "[-0.1]", "[0, 0, 0]", "0.3", "[1e300]", "[\"red\"]", "[]"}) {
    put(path("odd.json"), painted_file(colour));
    const Answer said = answer("synth " + at("odd.json") + " -o " + at("odd"));
    EXPECT_EQ(said.code, 2) << colour;
    EXPECT_NE(said.err.find("mean_albedo"), std::string::npos) << said.err;
    EXPECT_FALSE(fs::exists(path("odd")));
  }
}

TEST_F(Outputs, ValidateFindsTheMaterialOfASmallRig) {
  put(path("small.json"), small_recipe());
  const Answer said = answer("validate " + at("small.json") + " --seeds 1 --json");
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_NE(said.out.find("\"within_95\""), std::string::npos);
}

}  // namespace
}  // namespace hada
