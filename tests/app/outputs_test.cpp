#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "program.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = text_of(entry.path());
    }
  }
  return files;
}

class Outputs : public ::testing::Test {
 protected:
  // One capture and one run serve every test; one component is fitted fastest.
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<Scratch>();
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
  static std::unique_ptr<Scratch> scratch_;
};

std::unique_ptr<Scratch> Outputs::scratch_;

TEST_F(Outputs, AreTheSameBytesWithOneAndWithTwoThreads) {
  const Answer said = run_into("two", "--threads 2 --quiet");
  ASSERT_EQ(said.code, 0);
  EXPECT_EQ(said.out, "");
  const auto one = contents(path("one"));
  const auto two = contents(path("two"));
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [name, bytes] : one) EXPECT_TRUE(two.at(name) == bytes) << name;
}

TEST_F(Outputs, OfTheWholePathAreTheOnesPromised) {
  for (const std::string name : {"lights.json", "measure.json", "material.json", "report.html",
                                 "surface/surface.json", "surface/height.exr", "surface/normal.exr",
                                 "surface/height.png", "surface/lights.json", "synth/height.exr"}) {
    EXPECT_TRUE(fs::exists(path("one") / name)) << name;
  }
}

TEST_F(Outputs, ReportRefersToNothingOutsideItself) {
  const std::string report = text_of(path("one") / "report.html");
  for (const std::string outside : {"http:", "https:", "//cdn", "@import", "<script", "<link"}) {
    EXPECT_EQ(report.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(report.find(">nan"), std::string::npos);  // no number went missing
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

TEST_F(Outputs, ValidateFindsTheMaterialOfASmallRig) {
  put(path("small.json"), small_recipe());
  const Answer said = answer("validate " + at("small.json") + " --seeds 1 --json");
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_NE(said.out.find("\"within_95\""), std::string::npos);
}

}  // namespace
}  // namespace hada
