#include "io/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include <dlfcn.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/image_module.h"
#include "io/whole_file.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

// Beside the program, where it is installed, where it was built.
std::array<fs::path, 3> module_places() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  return {folder / "hada_image.so", folder / "../lib/hada/hada_image.so", HADA_IMAGE_MODULE};
}

const ImageModule& load_module() {
  for (const auto& place : module_places()) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) continue;
    void* const library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = library ? dlsym(library, image_module_symbol) : nullptr;
    if (symbol) return *static_cast<const ImageModule*>(symbol);
    throw Error(place.string() + ": the image module cannot be loaded (" + dlerror() +
                "); install hada and OpenImageIO again");
  }
  throw Error("hada_image.so: the image module is missing; put it beside the program");
}

const ImageModule& image_module() {
  static const ImageModule& module = load_module();
  return module;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write(const fs::path& path, const Image& image, ImageModule::Storage storage) {
  if (image.rows() == 0 || image.cols() == 0) {
    throw Error(path.string() + ": a picture without pixels cannot be written");
  }
  const auto problem = image_module().write(path.string(), threads(), image, storage, nullptr);
  if (!problem.empty()) throw Error(path.string() + ": " + problem);
}

}  // namespace

ImageFile read_image(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string() + ": no such file; check the name");
  if (fs::is_directory(path, ignored)) {
    throw Error(path.string() + ": is a folder; name the picture inside it");
  }
  if (!fs::is_regular_file(path, ignored)) {
    throw Error(path.string() + ": is not a file; name a picture");
  }
  if (fs::file_size(path, ignored) == 0) {
    throw Error(path.string() + ": is empty; copy or export it again");
  }
  if (!is_whole(bytes_of(path))) {
    throw Error(path.string() + ": is damaged or not complete; copy or export it again");
  }
  ImageFile file;
  const auto problem = image_module().read(path.string(), threads(), file);
  if (!problem.empty()) throw Error(path.string() + ": " + problem);
  return file;
}

bool has_image_name(const fs::path& path) {
  static constexpr std::array<std::string_view, 33> endings = {
      ".arw",  ".avif", ".bmp", ".cin", ".cr2",  ".cr3", ".dng", ".dpx", ".exr", ".gif",  ".hdr",
      ".heic", ".j2k",  ".jp2", ".jpe", ".jpeg", ".jpg", ".nef", ".orf", ".pbm", ".pef",  ".pfm",
      ".pgm",  ".png",  ".pnm", ".ppm", ".psd",  ".raf", ".rw2", ".tga", ".tif", ".tiff", ".webp"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void write_exr(const fs::path& path, const Image& image) {
  write(path, image, ImageModule::Storage::float32);
}

void write_integer_image(const fs::path& path, const Image& image, int bits) {
  write(path, image, bits == 8 ? ImageModule::Storage::bits8 : ImageModule::Storage::bits16);
}

std::vector<std::uint8_t> encode_png(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto problem =
      image_module().write("memory.png", threads(), image, ImageModule::Storage::bits8, &bytes);
  if (!problem.empty()) throw Error("memory.png: " + problem);
  return bytes;
}

float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace hada
