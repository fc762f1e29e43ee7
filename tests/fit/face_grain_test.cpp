#include "fit/face_grain.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double pitch = 0.1;

/// A stem whose face lies so far from the pith that it is nearly flat to the rings.
Wood<> stem() {
  Wood<> wood;
  wood.ring_radii_mm.clear();
  for (int k = 1; k < 120; ++k) wood.ring_radii_mm.push_back(2.0 * k + 0.4 * std::sin(1.7 * k));
  wood.fibre_shift = 0.3;
  wood.fibre_mm = 0.15;
  wood.fluctuation = 0.01;
  wood.cut_origin_mm = {150.0, 0.0, 0.0};
  wood.cut_right = {0.0, 1.0, 0.0};
  wood.cut_up = {0.0, 0.0, 1.0};
  return wood;
}

/// Drawn twice as fine as it is looked at, with noise.
Surface face(const Wood<>& wood, int rows, int cols, Seed seed) {
  const auto fine = synthesize(wood, {2 * rows, 2 * cols, pitch / 2, Unit::mm}, seed).albedo;
  Surface surface;
  surface.extent = {rows, cols, pitch, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = Image(rows, cols, 1);
  const auto grey = luminance(fine);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double mean = 0.25 * (double(grey(2 * row, 2 * col)) + grey(2 * row, 2 * col + 1) +
                                  grey(2 * row + 1, 2 * col) + grey(2 * row + 1, 2 * col + 1));
      surface.albedo.planes[0](row, col) = float(mean + 0.01 * gaussian(seed + 9, row, col));
    }
  }
  return surface;
}

TEST(FaceGrain, ReadsSpiralGrain) {
  for (const double spiral : {-0.12, 0.0, 0.2}) {
    auto wood = stem();
    wood.spiral = spiral;
    const auto grain = face_grain(face(wood, 400, 400, 1));
    EXPECT_EQ(grain.kind, FaceGrain::Kind::straight);
    // The fluctuation of 0.01 at most does not average out over a face; 0.3 deg is 0.005.
    EXPECT_NEAR(grain.gradient.value, spiral, 0.01);
    EXPECT_LT(grain.gradient.sigma, 0.005);
  }
}

TEST(FaceGrain, ReadsWavyGrain) {
  auto wood = stem();
  wood.spiral = 0.03;
  wood.wave_amplitude = 0.15;
  wood.wave_length_mm = 16.0;
  wood.wave_phase_rad = 0.8;
  const auto grain = face_grain(face(wood, 640, 400, 2));
  ASSERT_EQ(grain.kind, FaceGrain::Kind::wavy);
  EXPECT_NEAR(grain.gradient.value, 0.03, 0.01);
  EXPECT_NEAR(grain.amplitude.value, 0.15, 3.0 * grain.amplitude.sigma + 0.003);
  EXPECT_NEAR(grain.length.value, 16.0, 0.02 * 16.0);
  EXPECT_NEAR(grain.phase.value, 0.8, 0.15);
}

TEST(FaceGrain, ReadsInterlockedGrainOnARadialFace) {
  auto wood = stem();
  wood.interlock_amplitude = 0.12;
  wood.interlock_period = 8.0;  // rings of 2 mm: 16 mm
  wood.cut_right = {1.0, 0.0, 0.0};
  wood.cut_origin_mm = {150.0, 0.0, 0.0};
  wood.cut_up = {0.0, 0.0, 1.0};
  // On a radial face fibres run into the picture: a plane a little beside the pith shows them.
  wood.cut_right = {0.3, 1.0, 0.0};
  const auto grain = face_grain(face(wood, 300, 900, 3));
  ASSERT_EQ(grain.kind, FaceGrain::Kind::interlocked);
  // 16 mm along the radius, of which the face shows 0.3 / hypot(0.3, 1) for each mm, but the cut
  // bends away from the pith as well.
  const double along = 16.0 * std::hypot(0.3, 1.0) / 0.3;
  EXPECT_NEAR(grain.length.value, along, 0.12 * along);
}

TEST(FaceGrain, IsToldFromAnEndGrain) {
  EXPECT_TRUE(looks_like_a_face(face(stem(), 300, 300, 4)));
  auto end = stem();
  end.cut_origin_mm = {0.0, 0.0, 0.0};
  end.cut_right = {1.0, 0.0, 0.0};
  end.cut_up = {0.0, 1.0, 0.0};
  EXPECT_FALSE(looks_like_a_face(face(end, 300, 300, 5)));
  end.cut_origin_mm = {40.0, 10.0, 0.0};
  EXPECT_FALSE(looks_like_a_face(face(end, 300, 300, 6)));
}

TEST(FaceGrain, RefusesWhatHasNoFibres) {
  Surface surface;
  surface.extent = {200, 200, pitch, Unit::mm};
  surface.mask = full_mask(surface.extent);
  EXPECT_THROW(face_grain(surface), Error);  // no albedo
  surface.albedo = Image(Grid<float>(200, 200, 0.5f));
  EXPECT_THROW(face_grain(surface), Error);  // nothing on it
}

}  // namespace
}  // namespace hada
