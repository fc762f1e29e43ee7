#include "capture/lit_disc.h"

#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

TEST(LitDisc, TellsAShadowFromAWeakLamp) {
  Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  Photographs shaded = copy_of(photographs);
  for (float& value : photographs.images[3].planes[0]) value *= 0.05f;
  dim_disc(shaded.images[3].planes[0], {60.0, 100.0}, 26.0, 0.05f, 0.0f);
  const Sphere sphere{SphereKind::matte, {60.0, 100.0}, 25.0, 0.1, {}};
  EXPECT_EQ(lit_discs(photographs, sphere)[3].light, DiscLight::weak);
  EXPECT_EQ(lit_discs(photographs, sphere)[2].light, DiscLight::good);
  EXPECT_EQ(lit_discs(shaded, sphere)[3].light, DiscLight::shadowed);
}

}  // namespace
}  // namespace hada
