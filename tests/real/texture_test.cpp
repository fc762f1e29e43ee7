#include <filesystem>

#include <gtest/gtest.h>

#include "bench/accuracy.h"
#include "bench/texture_study.h"
#include "io/surface_file.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

TEST(RealTexture, OfASmallPieceLooksAlike) {
  const fs::path file = data_folder() / "wrinkle" / "fabric_2004.png";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const Surface fabric = read_surface(file, 0.1);
  for (const int side : {64, 96}) {
    const auto score = study_texture(piece_of(fabric, {16, 16, side, side}), 5);
    // What is asked for of whole pictures.
    EXPECT_LT(score.distance_db, score.floor_db + 0.6) << side;
  }
}

}  // namespace
}  // namespace hada
