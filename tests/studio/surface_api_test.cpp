#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json.h"
#include "io/output.h"
#include "io/surface_file.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SurfaceRequests, ListAndShowWhatLiesInTheFolderAlone) {
  const TemporaryFolder scratch;
  Surface surface;
  surface.extent = {8, 8, 0.5, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.height = Grid<float>(8, 8, 0.0f);
  surface.normals = normals_of(surface.height, surface.mask, 0.5);
  for (const char* place : {"folder/sheet", "outside"}) {
    Output output(scratch / place);
    write_surface(output, "", surface);
    output.commit();
  }
  std::filesystem::create_directory_symlink(scratch / "outside", scratch / "folder/link");
  put(scratch / "folder/broken.png", "no picture");
  const RunningStudio studio(scratch / "folder");
  const std::string list = body_of(get(studio, "api/surface/list"));
  EXPECT_THAT(list, HasSubstr(R"({"name":"sheet","kind":"surface"})"));
  EXPECT_THAT(list, Not(HasSubstr("link")));
  const std::string maps = post(studio, "api/surface/maps", R"({"name": "sheet"})");
  EXPECT_EQ(status_of(maps), 200);
  EXPECT_EQ(body_of(maps).size(), 40u + 64 * (8 + 4));
  // A material on the same lattice, to be seen beside it.
  const std::string like = post(studio, "api/surface/like", R"({"name": "sheet", "seed": 1, "file":
    {"hada": "material/1", "material": "wrinkle", "parameters": {"components": [{"amplitude_mm":
    0.1, "long_mm": 1.0, "short_mm": 1.0, "angle_rad": 0.0}], "floor_mm4": 0.0}}})");
  EXPECT_EQ(status_of(like), 200) << like;
  EXPECT_EQ(body_of(like).size(), 40u + 64 * (8 + 8 + 4));
  for (const char* name : {"link", "../outside", "broken.png", "", "missing"}) {
    const std::string said =
        post(studio, "api/surface/maps", std::string(R"({"name": ")") + name + "\"}");
    EXPECT_EQ(status_of(said), 422) << name;
    EXPECT_THAT(said, Not(HasSubstr(scratch.path().string()))) << name;
  }
}

}  // namespace
}  // namespace hada
