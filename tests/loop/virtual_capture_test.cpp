#include <gtest/gtest.h>

#include "bench/accuracy.h"

namespace hada {
namespace {

// reconstruct(photograph(s)) ~ s: rendered four times finer than it is seen, with sensor noise,
// cast shadows and 16 bits, lights read off the spheres in the frame.
TEST(VirtualCapture, ComesBackAsTheSurfaceItWasTakenOf) {
  const LoopScore score = synthetic_loop(3);
  // The matte sphere of 62 px is known to 0.1 px: 0.1 degrees.
  EXPECT_LT(score.lights_deg, 0.3);
  // Noise of 0.15 % over eight lights is 0.1 degrees; shadow borders add to the mean.
  EXPECT_LT(score.normals_deg, 0.5);
  EXPECT_LT(score.height_share, 0.02);
}

}  // namespace
}  // namespace hada
