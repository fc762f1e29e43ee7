#include "io/image_module.h"

#include <algorithm>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace hada {
namespace {

class Module : public testing::Test {
 protected:
  Module() {
    void* const library = dlopen(HADA_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);
    if (library) module_ = static_cast<const ImageModule*>(dlsym(library, image_module_symbol));
  }
  void SetUp() override { ASSERT_NE(module_, nullptr) << dlerror(); }

  /// Keeps the first value of every row.
  std::string read(const std::filesystem::path& path) {
    return module_->read(path.string(), 1,
                         {[&](const PictureShape& shape) {
                            shape_ = shape;
                            return true;
                          },
                          [&](int, const float* pixels) { firsts_.push_back(pixels[0]); }});
  }

  const ImageModule* module_ = nullptr;
  TemporaryFolder folder_;
  PictureShape shape_;
  std::vector<float> firsts_;
};

TEST_F(Module, ReadsWhatItWroteRowByRow) {
  const PictureShape shape{3, 5, 1, 16, false};
  const auto path = folder_ / "a.png";
  const auto row = [](int r, float* pixels) { std::fill_n(pixels, 5, float(r) / 4.0f); };
  EXPECT_EQ(module_->write(path.string(), 1, shape, ImageModule::Storage::bits16, row, nullptr),
            "");
  EXPECT_EQ(read(path), "");
  EXPECT_EQ(shape_.rows, 3);
  EXPECT_EQ(shape_.cols, 5);
  EXPECT_EQ(shape_.bits, 16);
  ASSERT_EQ(firsts_.size(), 3u);
  for (int r = 0; r < 3; ++r) EXPECT_NEAR(firsts_[std::size_t(r)], r / 4.0f, 0.5f / 65535.0f);
}

TEST_F(Module, WritesIntoMemory) {
  std::vector<std::uint8_t> bytes;
  const auto row = [](int, float* pixels) { std::fill_n(pixels, 4, 0.5f); };
  EXPECT_EQ(module_->write("memory.png", 1, {2, 4, 1, 8, false}, ImageModule::Storage::bits8, row,
                           &bytes),
            "");
  ASSERT_GT(bytes.size(), 8u);
  EXPECT_EQ(bytes[1], 'P');
}

TEST_F(Module, SaysWhatIsWrongInsteadOfThrowing) {
  put(folder_ / "broken.png", "\x89PNG\r\n\x1a\n and no more");
  put(folder_ / "empty.tif", "");
  for (const char* name : {"broken.png", "empty.tif", "missing.png"})
    EXPECT_NE(read(folder_ / name), "") << name;
  EXPECT_TRUE(firsts_.empty());
}

}  // namespace
}  // namespace hada
