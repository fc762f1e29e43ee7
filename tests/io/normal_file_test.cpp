#include "io/normal_file.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/image_file.h"
#include "temporary_folder.h"

namespace hada {
namespace {

Image map_of(const Eigen::Vector3f& value, float scale, float offset) {
  Image image(2, 3, 3);
  for (int axis = 0; axis < 3; ++axis) {
    for (float& v : image.planes[std::size_t(axis)]) v = scale * value[axis] + offset;
  }
  return image;
}

TEST(ReadNormals, TakesFloatsAsTheyAreAndIntegersAsMinusOneToOne) {
  const TemporaryFolder folder;
  const Eigen::Vector3f normal = Eigen::Vector3f(0.3f, -0.4f, 1.0f).normalized();
  write_exr(folder / "a.exr", map_of(normal, 1.0f, 0.0f));
  write_integer_image(folder / "b.png", map_of(normal, 0.5f, 0.5f), 16);
  write_integer_image(folder / "c.png", map_of(normal, 0.5f, 0.5f), 8);
  // Half a step of the integers, twice that in the vector, on three axes.
  EXPECT_LT((read_normals(folder / "a.exr", false).normals(1, 2) - normal).norm(), 1e-6f);
  EXPECT_LT((read_normals(folder / "b.png", false).normals(1, 2) - normal).norm(), 2.0f / 65535);
  EXPECT_LT((read_normals(folder / "c.png", false).normals(1, 2) - normal).norm(), 2.0f / 255);
  const Eigen::Vector3f flipped = read_normals(folder / "a.exr", true).normals(0, 0);
  EXPECT_LT((flipped - Eigen::Vector3f(normal.x(), -normal.y(), normal.z())).norm(), 1e-6f);
}

TEST(ReadNormals, LeavesOutWhatIsNoNormalTowardsTheCamera) {
  const TemporaryFolder folder;
  Image image = map_of(Eigen::Vector3f::UnitZ(), 1.0f, 0.0f);
  image.planes[2](0, 0) = 0.0f;   // nothing
  image.planes[2](0, 1) = -1.0f;  // looks away
  write_exr(folder / "a.exr", image);
  const NormalFile file = read_normals(folder / "a.exr", false);
  EXPECT_EQ(file.mask(0, 0), 0);
  EXPECT_EQ(file.mask(0, 1), 0);
  EXPECT_EQ(file.mask(0, 2), 1);
  EXPECT_EQ(file.normals(0, 1), Eigen::Vector3f(Eigen::Vector3f::UnitZ()));
  EXPECT_DOUBLE_EQ(file.share_away, 1.0 / 5.0);  // of those that are long enough
  EXPECT_EQ(file.share_off_length, 0.0);
}

TEST(ReadNormals, SaysHowManyAreNoUnitVectors) {
  const TemporaryFolder folder;
  Image image = map_of(Eigen::Vector3f(0.6f, 0.0f, 0.8f), 1.0f, 0.0f);
  image.planes[0](1, 1) = 1.0f;  // 1.28 long
  write_exr(folder / "a.exr", image);
  EXPECT_DOUBLE_EQ(read_normals(folder / "a.exr", false).share_off_length, 1.0 / 6.0);
  // Written as a picture for the eye would be: 0.5 becomes 0.735.
  write_integer_image(folder / "b.png", map_of(Eigen::Vector3f(0.735f, 0.735f, 1.0f), 1.0f, 0.0f),
                      16);
  EXPECT_EQ(read_normals(folder / "b.png", false).share_off_length, 1.0);
}

TEST(ReadNormals, RefusesFloatsThatAreCodedAsIntegersAre) {
  const TemporaryFolder folder;
  for (const Eigen::Vector3f& direction :
       {Eigen::Vector3f(0.0f, 0.0f, 1.0f), Eigen::Vector3f(0.6f, -0.5f, 0.62f)}) {
    write_exr(folder / "coded.exr", map_of(direction.normalized(), 0.5f, 0.5f));
    EXPECT_THROW(read_normals(folder / "coded.exr", false), Error);
  }
}

TEST(ReadNormals, RefusesAGreyPictureAndOneWithoutNormals) {
  const TemporaryFolder folder;
  write_integer_image(folder / "grey.png", Image(2, 2, 1), 8);
  write_exr(folder / "zero.exr", Image(2, 2, 3));
  EXPECT_THROW(read_normals(folder / "grey.png", false), Error);
  EXPECT_THROW(read_normals(folder / "zero.exr", false), Error);
}

TEST(ReadIntrinsics, ReadsAMatrixAndRefusesWhatIsNone) {
  const TemporaryFolder folder;
  const auto put = [&](const std::string& text) {
    std::ofstream(folder / "K.txt") << text;
    return folder / "K.txt";
  };
  const Eigen::Matrix3d k = read_intrinsics(put("3.7e3 0 305\n0 3700.5 255\n0 0 1\n"));
  EXPECT_EQ(k(0, 0), 3700.0);
  EXPECT_EQ(k(1, 2), 255.0);
  for (const char* text :
       {"", "1 2 3", "0 0 5 0 1 5 0 0 1", "10 1 5 0 10 5 0 0 1", "10 0 5 0 10 5 0 0 2",
        "10 0 5 0 10 5 0 0 1 7", "10 0 nan 0 10 5 0 0 1", "ten 0 5 0 10 5 0 0 1"}) {
    EXPECT_THROW(read_intrinsics(put(text)), Error) << text;
  }
  EXPECT_THROW(read_intrinsics(folder / "missing.txt"), Error);
}

}  // namespace
}  // namespace hada
