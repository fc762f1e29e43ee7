#include "app/files.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "app/draw/maps.h"
#include "core/error.h"
#include "io/image_file.h"

namespace hada {
namespace {

constexpr int longest_preview = 2048;  // px: more than a screen shows

}  // namespace

void put_text(Output& output, const std::string& name, const std::string& text) {
  const auto path = output.file(name);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    throw Error((output.folder() / name).string() +
                ": cannot be written; check that the disk has room");
  }
}

void put_picture(Output& output, const std::string& name, const Image& picture) {
  write_integer_image(output.file(name), picture, 8);
}

void put_previews(Output& output, const std::string& folder, const Surface& surface) {
  if (std::max(surface.extent.rows, surface.extent.cols) > longest_preview) {
    if (!surface.albedo.empty()) {
      put_picture(output, folder + "albedo.png", shrunk(albedo_picture(surface), longest_preview));
    }
    return put_previews(output, folder, shrunk(surface, longest_preview));
  }
  if (surface.has_height()) {
    put_picture(output, folder + "height.png", relief_picture(surface, relief_style(surface)));
  }
  if (!surface.normals.empty() || surface.has_height()) {
    put_picture(output, folder + "normal.png", normal_picture(surface));
  }
  if (!surface.albedo.empty()) put_picture(output, folder + "albedo.png", albedo_picture(surface));
}

std::filesystem::path shipped_recipe(const std::string& name) {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  for (const std::filesystem::path& folder :
       {program.parent_path().parent_path() / "share" / "hada" / "data_synthetic",
        std::filesystem::path(HADA_RECIPES)}) {
    if (std::filesystem::exists(folder / name, ignored)) return folder / name;
  }
  throw Error(name + ": this recipe was not found beside the program; name it with --recipe");
}

std::string version() {
  return HADA_VERSION;
}

}  // namespace hada
