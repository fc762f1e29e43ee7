#include "capture/likeness.h"

#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

class Likeness : public ::testing::Test {
 protected:
  const Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  const Overview all = overview(photographs);
  const Circle matte{{60.0, 55.0}, 25.0, 1.0, 0.1};
  const Circle chrome{{50.0, 145.0}, 25.0, 1.0, 0.1};
  const Circle on_sheet{{210.0, 100.0}, 25.0, 1.0, 0.1};
};

TEST_F(Likeness, KnowsAMatteSphereFromAMirrorAndASheet) {
  EXPECT_GT(matte_likeness(photographs, all, matte), 0.9);
  EXPECT_LT(matte_likeness(photographs, all, chrome), 0.3);
  EXPECT_LT(matte_likeness(photographs, all, on_sheet), 0.6);
}

TEST_F(Likeness, KnowsAMirrorFromAMatteSphereAndASheet) {
  EXPECT_GT(chrome_likeness(photographs, all, chrome), 0.9);
  EXPECT_EQ(chrome_likeness(photographs, all, matte), 0.0);
  EXPECT_EQ(chrome_likeness(photographs, all, on_sheet), 0.0);
}

}  // namespace
}  // namespace hada
