#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/image.h"
#include "program.h"

namespace hada {

namespace fs = std::filesystem;

// One sentence, exit code 2, and nothing new on the disk.
inline void expect_refusal(const std::string& words, const fs::path& out) {
  const Answer said = answer(words + " -o " + out.string());
  EXPECT_EQ(said.code, 2) << words;
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
  EXPECT_EQ(said.err.rfind("hada: ", 0), 0u) << said.err;
  EXPECT_TRUE(said.out.empty()) << said.out;
  EXPECT_FALSE(fs::exists(out)) << out;
}

inline Image flat_picture(int rows, int cols, float value) {
  Image image(rows, cols, 1);
  std::fill(image.planes[0].begin(), image.planes[0].end(), value);
  return image;
}

}  // namespace hada
