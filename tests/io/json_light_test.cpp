#include "io/json_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

TEST(JsonLight, MakesDirectionsUnitLengthWhateverTheirLength) {
  const Json json = Json::parse(R"({"a": [0, 3, 4], "tiny": [0, 3e-200, 4e-200], "zero": [0, 0, 0],
                                    "huge": [0, 3e200, 4e200], "short": [1, 2]})");
  JsonObject object(json, "f.json");
  for (const char* key : {"a", "tiny", "huge"}) {
    const auto direction = direction_from(object, key);
    EXPECT_NEAR(direction.y(), 0.6, 1e-15) << key;  // two roundings of numbers below 1
    EXPECT_NEAR(direction.z(), 0.8, 1e-15) << key;
  }
  EXPECT_THAT(error_of([&] { direction_from(object, "zero"); }), HasSubstr("has no length"));
  EXPECT_THAT(error_of([&] { direction_from(object, "short"); }), HasSubstr("3 finite numbers"));
}

TEST(JsonLight, ReadsOneStrengthOrThree) {
  const Json json = Json::parse(R"({"one": 2, "three": [1, 2, 3], "none": 0, "dark": [1, -1, 1]})");
  JsonObject object(json, "f.json");
  EXPECT_EQ(strength_from(object, "one"), Eigen::Vector3d(2, 2, 2));
  EXPECT_EQ(strength_from(object, "three"), Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(error_of([&] { strength_from(object, "none"); }), HasSubstr("larger than 0"));
  EXPECT_THAT(error_of([&] { strength_from(object, "dark"); }), HasSubstr("larger than 0"));
}

TEST(JsonLight, WritesEqualStrengthsAsOneNumber) {
  EXPECT_EQ(json_of_strength({2, 2, 2}).dump(), "2.0");
  EXPECT_EQ(json_of_strength({1, 2, 3}).dump(), "[1.0,2.0,3.0]");
}

}  // namespace
}  // namespace hada
