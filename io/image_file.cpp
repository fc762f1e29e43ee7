#include "io/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

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

// The bytes of a file, read as they are asked for.
class MappedFile {
 public:
  explicit MappedFile(const fs::path& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    std::error_code ignored;
    const auto size = fs::file_size(path, ignored);
    void* const bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    close(file);
    if (bytes != MAP_FAILED) bytes_ = {static_cast<const char*>(bytes), size};
  }
  ~MappedFile() {
    if (!bytes_.empty()) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
};

void require_picture_file(const fs::path& path) {
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
  if (!is_whole(MappedFile(path).bytes())) {
    throw Error(path.string() + ": is damaged or not complete; copy or export it again");
  }
}

PictureShape shape_of(const Image& image) {
  return {.rows = image.rows(), .cols = image.cols(), .channels = image.channels()};
}

RowSource rows_of(const Image& image) {
  return [&image](int row, float* pixels) {
    for (int col = 0; col < image.cols(); ++col) {
      for (const auto& plane : image.planes) *pixels++ = plane(row, col);
    }
  };
}

void write(const fs::path& path, const PictureShape& shape, ImageModule::Storage storage,
           const RowSource& row) {
  if (shape.rows == 0 || shape.cols == 0) {
    throw Error(path.string() + ": a picture without pixels cannot be written");
  }
  const auto problem = image_module().write(path.string(), threads(), shape, storage, row, nullptr);
  if (!problem.empty()) throw Error(path.string() + ": " + problem);
}

ImageModule::Storage integers_of(int bits) {
  return bits == 8 ? ImageModule::Storage::bits8 : ImageModule::Storage::bits16;
}

}  // namespace

void read_rows(const fs::path& path, const RowReader& reader) {
  require_picture_file(path);
  std::exception_ptr thrown;  // by the reader: none may cross the module
  bool goes_on = true;
  const auto guarded = [&](const auto& work) {
    try {
      if (goes_on) work();
    } catch (...) {
      thrown = std::current_exception();
      goes_on = false;
    }
  };
  const RowReader safe{
      [&](const PictureShape& shape) {
        guarded([&] { goes_on = reader.begin(shape); });
        return goes_on;
      },
      [&](int row, const float* pixels) { guarded([&] { reader.row(row, pixels); }); }};
  const auto problem = image_module().read(path.string(), threads(), safe);
  if (thrown) std::rethrow_exception(thrown);
  if (!problem.empty()) throw Error(path.string() + ": " + problem);
}

ImageFile read_image(const fs::path& path) {
  ImageFile file;
  read_rows(path, {[&](const PictureShape& shape) {
                     file.image = Image(shape.rows, shape.cols, shape.channels);
                     file.bits = shape.bits;
                     file.floating = shape.floating;
                     return true;
                   },
                   [&](int row, const float* pixels) {
                     for (int col = 0; col < file.image.cols(); ++col) {
                       for (auto& plane : file.image.planes) plane(row, col) = *pixels++;
                     }
                   }});
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
  write_exr_rows(path, shape_of(image), rows_of(image));
}

void write_exr_rows(const fs::path& path, const PictureShape& shape, const RowSource& row) {
  write(path, shape, ImageModule::Storage::float32, row);
}

void write_integer_image(const fs::path& path, const Image& image, int bits) {
  write_integer_rows(path, shape_of(image), bits, rows_of(image));
}

void write_integer_rows(const fs::path& path, const PictureShape& shape, int bits,
                        const RowSource& row) {
  write(path, shape, integers_of(bits), row);
}

std::vector<std::uint8_t> encode_png(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto problem = image_module().write("memory.png", threads(), shape_of(image),
                                            ImageModule::Storage::bits8, rows_of(image), &bytes);
  if (!problem.empty()) throw Error("memory.png: " + problem);
  return bytes;
}

}  // namespace hada
