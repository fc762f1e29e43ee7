#include "io/capture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

// A folder with pictures a.png, b.png, c.png, a mask and this manifest.
class WithManifest : public TemporaryFolder {
 public:
  explicit WithManifest(const std::string& keys) {
    for (const char* name : {"a.png", "b.png", "c.png", "mask.png"}) put(*this / name, "x");
    put(*this / "capture.json", R"({"hada": "capture/1")" + keys + "}");
  }
};

std::string error_of_manifest(const std::string& keys) {
  const WithManifest folder(keys);
  return error_of([&] { read_capture_file(folder.path()); });
}

TEST(CaptureFile, NeedsNoManifest) {
  const TemporaryFolder folder;
  for (const char* name : {"p10.png", "p2.png", "my.mask.png", "readme.md"}) put(folder / name, "");
  const auto capture = read_capture_file(folder.path());
  ASSERT_EQ(capture.pictures.size(), 2u);
  EXPECT_EQ(capture.pictures[0].name, "p2.png");
  EXPECT_EQ(capture.pictures[0].file, folder / "p2.png");
  EXPECT_EQ(capture.mask, folder / "my.mask.png");
  EXPECT_EQ(capture.encoding, "auto");
  EXPECT_THAT(capture.left_out, testing::ElementsAre("readme.md (not an image)"));
}

TEST(CaptureFile, TakesFromTheFolderWhatTheManifestDoesNotSay) {
  const WithManifest folder(R"(, "pitch_mm": 0.25, "mask": "c.png")");
  const auto capture = read_capture_file(folder.path());
  EXPECT_EQ(capture.pitch_mm, 0.25);
  EXPECT_EQ(capture.mask, folder / "c.png");
  ASSERT_EQ(capture.pictures.size(), 2u);  // c.png has been given another role
  EXPECT_THAT(capture.left_out, testing::ElementsAre("mask.png (another mask)"));
}

TEST(CaptureFile, ReadsEveryKeyOfTheManifest) {
  const WithManifest folder(R"(,
    "images": ["b.png", {"file": "a.png", "light": [0, 0, 2], "strength": [1, 2, 3]}],
    "encoding": "srgb", "pitch_mm": 0.26, "sample_box_px": [1, 2, 3, 4],
    "spheres": [{"kind": "auto", "box_px": [5, 6, 7, 8], "diameter_mm": 38}, {"kind": "chrome"}],
    "mask": "mask.png", "dark": "c.png", "lamps": "near", "vignetting": [-0.2, 0.1, 0],
    "camera": {"model": "perspective", "focal_px": 3000, "distance_mm": 900})");
  const auto capture = read_capture_file(folder.path());
  ASSERT_EQ(capture.pictures.size(), 2u);
  EXPECT_EQ(capture.pictures[0].name, "b.png");
  EXPECT_FALSE(capture.pictures[0].direction);
  EXPECT_EQ(capture.pictures[1].direction, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(capture.pictures[1].strength, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(capture.encoding, "srgb");
  EXPECT_EQ(capture.sample_box, (BoxPx{1, 2, 3, 4}));
  ASSERT_EQ(capture.spheres.size(), 2u);
  EXPECT_FALSE(capture.spheres[0].kind);
  EXPECT_EQ(capture.spheres[0].box, (BoxPx{5, 6, 7, 8}));
  EXPECT_EQ(capture.spheres[0].diameter_mm, 38.0);
  EXPECT_EQ(capture.spheres[1].kind, SphereKind::chrome);
  EXPECT_EQ(capture.dark, folder / "c.png");
  EXPECT_FALSE(capture.flat);
  EXPECT_TRUE(capture.camera->perspective);
  EXPECT_EQ(capture.camera->focal_px, 3000.0);
  EXPECT_EQ(capture.camera->distance_mm, 900.0);
  EXPECT_EQ(capture.lamps, "near");
  EXPECT_EQ(capture.vignetting, (std::array{-0.2, 0.1, 0.0}));
}

TEST(CaptureFile, NamesEveryFlawOfTheManifest) {
  EXPECT_THAT(error_of_manifest(R"(, "images": ["no.png"])"),
              HasSubstr("images[0]: \"file\" names \"no.png\""));
  EXPECT_THAT(error_of_manifest(R"(, "images": [])"), HasSubstr("\"images\" is empty"));
  EXPECT_THAT(error_of_manifest(R"(, "images": ["a.png", "a.png"])"), HasSubstr("a.png twice"));
  EXPECT_THAT(error_of_manifest(R"(, "images": [7])"), HasSubstr("images[0]: must be"));
  EXPECT_THAT(error_of_manifest(R"(, "pitch_mm": 0)"), HasSubstr("\"pitch_mm\" must be larger"));
  EXPECT_THAT(error_of_manifest(R"(, "pitch": 1)"), HasSubstr("\"pitch\" is not a known key"));
  EXPECT_THAT(error_of_manifest(R"(, "encoding": "log")"), HasSubstr("auto, linear or srgb"));
  EXPECT_THAT(error_of_manifest(R"(, "spheres": [{"kind": "gold"}])"),
              HasSubstr("spheres[0]: \"kind\" must be auto, matte or chrome"));
  EXPECT_THAT(error_of_manifest(R"(, "sample_box_px": [5, 5, 1, 9])"),
              HasSubstr("\"sample_box_px\" must be [left, top, right, bottom]"));
  EXPECT_THAT(error_of_manifest(R"(, "mask": "none.png")"), HasSubstr("\"none.png\""));
  EXPECT_THAT(error_of_manifest(R"(, "camera": {"model": "fish"})"),
              HasSubstr("capture.json: camera: \"model\""));
  EXPECT_THAT(error_of_manifest(R"(, "lamps": "red")"), HasSubstr("auto, distant or near"));
  EXPECT_THAT(error_of_manifest(R"(, "vignetting": [-0.2])"), HasSubstr("vignetting"));
  EXPECT_THAT(error_of_manifest(R"(, "vignetting": [-1, 0, 0])"), HasSubstr("0.05"));
  EXPECT_THAT(error_of_manifest(R"(, "vignetting": [1e300, 0, 0])"), HasSubstr("vignetting"));
  EXPECT_EQ(error_of_manifest(""), "");
}

TEST(CaptureFile, RefusesAFolderWithoutPhotographs) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read_capture_file(folder.path()); }), HasSubstr("no photographs"));
  put(folder / "mask.png", "");
  EXPECT_THAT(error_of([&] { read_capture_file(folder.path()); }), HasSubstr("no photographs"));
  EXPECT_THAT(error_of([&] { read_capture_file(folder / "none"); }), HasSubstr("no such folder"));
}

// A manifest of any kind over the files of `folder`, drawn from `seed`.
CaptureFile some_capture(const TemporaryFolder& folder, Seed seed) {
  int turn = 0;
  const auto draw = [&] { return uniform(seed, turn++); };
  const auto box = [&]() -> std::optional<BoxPx> {
    if (draw() < 0.5) return std::nullopt;
    return BoxPx{-draw(), -draw(), draw(), draw()};
  };
  const auto length = [&]() -> std::optional<double> {
    return draw() < 0.5 ? std::optional<double>() : draw();
  };
  CaptureFile capture;
  capture.folder = folder.path();
  for (const std::string name : {"a.png", "b.png", "c.png"}) {
    CaptureFile::Picture picture{folder / name, name, std::nullopt, std::nullopt};
    if (draw() < 0.5) picture.direction = Eigen::Vector3d(draw(), draw(), draw()).normalized();
    if (draw() < 0.5) picture.strength = Eigen::Vector3d(draw(), draw(), draw());
    capture.pictures.push_back(picture);
  }
  capture.encoding = draw() < 0.5 ? "auto" : "linear";
  capture.pitch_mm = length();
  if (draw() < 0.5) capture.spheres.push_back({SphereKind::matte, box(), length()});
  if (draw() < 0.5) capture.spheres.push_back({std::nullopt, box(), length()});
  capture.sample_box = box();
  if (draw() < 0.5) capture.mask = folder / "mask.png";
  if (draw() < 0.5) capture.camera = {draw() < 0.5, length(), length()};
  if (draw() < 0.5) capture.lamps = "distant";
  if (draw() < 0.5) capture.vignetting = {-0.3 * draw(), 0.1 * draw(), 0.0};
  return capture;
}

RC_GTEST_PROP(CaptureFile, ReturnsFromItsTextWhatWasWritten, (std::uint64_t seed)) {
  const WithManifest folder("");
  const CaptureFile capture = some_capture(folder, seed);
  put(folder / "capture.json", capture_text(capture));
  const CaptureFile again = read_capture_file(folder.path());
  RC_ASSERT(again.pictures.size() == capture.pictures.size());
  for (std::size_t i = 0; i < capture.pictures.size(); ++i) {
    const auto& a = capture.pictures[i];
    const auto& b = again.pictures[i];
    RC_ASSERT(a.file == b.file && a.name == b.name && a.strength == b.strength);
    RC_ASSERT(a.direction.has_value() == b.direction.has_value());
    // Normalised once more: a few roundings of numbers below 1.
    RC_ASSERT(!a.direction || (*a.direction - *b.direction).norm() < 1e-15);
  }
  RC_ASSERT(again.spheres.size() == capture.spheres.size());
  for (std::size_t i = 0; i < capture.spheres.size(); ++i) {
    RC_ASSERT(again.spheres[i].kind == capture.spheres[i].kind);
    RC_ASSERT(again.spheres[i].box == capture.spheres[i].box);
    RC_ASSERT(again.spheres[i].diameter_mm == capture.spheres[i].diameter_mm);
  }
  RC_ASSERT(again.encoding == capture.encoding && again.pitch_mm == capture.pitch_mm);
  RC_ASSERT(again.sample_box == capture.sample_box && again.mask == capture.mask);
  RC_ASSERT(again.lamps == capture.lamps && again.vignetting == capture.vignetting);
  RC_ASSERT(again.camera.has_value() == capture.camera.has_value());
  if (capture.camera) {
    RC_ASSERT(again.camera->perspective == capture.camera->perspective);
    RC_ASSERT(again.camera->focal_px == capture.camera->focal_px);
    RC_ASSERT(again.camera->distance_mm == capture.camera->distance_mm);
  }
}

RC_GTEST_PROP(CaptureFile, SurvivesCutsAndChangedBytes,
              (std::uint64_t seed, std::uint16_t place, char byte, bool cut)) {
  const WithManifest folder("");
  std::string text = capture_text(some_capture(folder, seed));
  const std::size_t at = place % text.size();
  if (cut)
    text.resize(at);
  else
    text[at] = byte;
  put(folder / "capture.json", text);
  error_of([&] { read_capture_file(folder.path()); });
}

}  // namespace
}  // namespace hada
