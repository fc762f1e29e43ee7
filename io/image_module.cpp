#include "io/image_module.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace hada {
namespace {

constexpr std::int64_t most_pixels = std::int64_t(1) << 28;

// Only the first line, without its full stop: the reason becomes a part of our sentence.
std::string first_line(std::string text) {
  text.resize(std::min(text.find('\n'), text.size()));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

// OpenImageIO prints errors that nobody fetched, so they are always fetched.
template <class File>
std::string reason(File& file) {
  const std::string own = file ? file->geterror() : "";
  const std::string global = OIIO::geterror();
  return first_line(own.empty() ? global : own);
}

std::string damaged(const std::string& why) {
  return "is damaged or not complete" + (why.empty() ? "" : " (" + why + ")") +
         "; copy or export it again";
}

void use_threads(int threads) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  OIIO::attribute("threads", threads);
  OIIO::attribute("exr_threads", threads);
  OIIO::attribute("limits:imagesize_MB", int(most_pixels >> 20) * 16);
}

// The channels that make the picture: all planes of grey or colour, no alpha.
std::vector<int> picture_channels(const OIIO::ImageSpec& spec) {
  const auto named = [&](const char* name) { return spec.channelindex(name); };
  if (spec.nchannels <= 4) {
    if (spec.nchannels <= 2) return {spec.alpha_channel == 0 && spec.nchannels == 2 ? 1 : 0};
    return {0, 1, 2};
  }
  if (named("R") >= 0 && named("G") >= 0 && named("B") >= 0) {
    return {named("R"), named("G"), named("B")};
  }
  if (named("Y") >= 0) return {named("Y")};
  return {};
}

// What is wrong with the size that the file claims; checked before anything is allocated for it.
std::string size_problem(const OIIO::ImageSpec& spec, const std::string& path) {
  if (spec.deep || spec.depth > 1) return "is deeper than a picture; export one flat layer of it";
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return "has no pixels";
  const std::int64_t pixels = std::int64_t(spec.width) * spec.height;
  if (pixels > most_pixels) {
    return "claims " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
           " pixels, more than 2^28; make it smaller or crop it";
  }
  // Deflate, the densest of the usual codes, packs at most 1032 bytes into one.
  constexpr std::int64_t small = 1 << 24;
  constexpr std::int64_t densest = 4096;
  const auto bytes = std::int64_t(std::filesystem::file_size(path));
  if (pixels > small && pixels / densest > bytes)
    return damaged("too short for the size it claims");
  return "";
}

int bits_of(const OIIO::ImageSpec& spec, bool floating) {
  const int stored = int(spec.format.size()) * 8;
  if (floating) return stored;
  const int said = spec.get_int_attribute("oiio:BitsPerSample", stored);
  return said > 0 ? std::min(said, stored) : stored;
}

// A band of rows at a time: enough for all threads, little beside the picture. Whole rows of tiles.
int rows_of_band(const OIIO::ImageSpec& spec) {
  constexpr int rows = 256;
  return spec.tile_height > 1 ? (rows + spec.tile_height - 1) / spec.tile_height * spec.tile_height
                              : rows;
}

// Rows [begin, end) of the channels [first, last), side by side.
bool read_band(OIIO::ImageInput& input, int begin, int end, int first, int last, float* pixels) {
  const OIIO::ImageSpec& spec = input.spec();
  if (spec.tile_width == 0) {
    return input.read_scanlines(0, 0, spec.y + begin, spec.y + end, 0, first, last, OIIO::TypeFloat,
                                pixels);
  }
  return input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end, 0, 1,
                          first, last, OIIO::TypeFloat, pixels);
}

std::string read_open_file(OIIO::ImageInput& input, const std::string& path,
                           const RowReader& reader) {
  const OIIO::ImageSpec& spec = input.spec();
  if (auto problem = size_problem(spec, path); !problem.empty()) return problem;
  const std::vector<int> channels = picture_channels(spec);
  if (channels.empty()) {
    return "has " + std::to_string(spec.nchannels) +
           " channels and none named Y or R, G, B; export grey or colour";
  }

  const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
  const int stride = *last - *first + 1;
  const bool floating = spec.format.is_floating_point();
  if (!reader.begin(
          {spec.height, spec.width, int(channels.size()), bits_of(spec, floating), floating})) {
    return "";
  }
  const int band = std::min(rows_of_band(spec), spec.height);
  std::vector<float> pixels(std::size_t(band) * spec.width * stride);
  std::vector<float> row_pixels(std::size_t(spec.width) * channels.size());
  for (int begin = 0; begin < spec.height; begin += band) {
    const int end = std::min(begin + band, spec.height);
    if (!read_band(input, begin, end, *first, *last + 1, pixels.data())) {
      return damaged(first_line(input.geterror()));
    }
    const float* source = pixels.data();
    for (int row = begin; row < end; ++row) {
      float* to = row_pixels.data();
      for (int col = 0; col < spec.width; ++col, source += stride) {
        for (const int channel : channels) *to++ = source[channel - *first];
      }
      reader.row(row, row_pixels.data());
    }
  }
  return "";
}

std::string read(const std::string& path, int threads, const RowReader& reader) noexcept try {
  use_threads(threads);
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, not multiplied by alpha
  wishes.attribute("raw:ColorSpace", "sRGB-linear");
  wishes.attribute("raw:auto_bright", 0);
  wishes.attribute("raw:user_flip", 0);
  const auto input = OIIO::ImageInput::open(path, &wishes);
  const std::string why = reason(input);
  if (!input) return "is not a picture that can be read; export it as PNG, TIFF, JPEG or EXR";
  std::string problem = read_open_file(*input, path, reader);
  input->close();
  const std::string late = reason(input);
  if (problem.empty() && !late.empty()) problem = damaged(late);
  return problem;
} catch (const std::bad_alloc&) {
  return "does not fit into memory; make it smaller or crop it";
} catch (const std::exception& error) {
  return damaged(first_line(error.what()));
}

template <class T>
T as_integer(float value) {
  constexpr float full = std::numeric_limits<T>::max();
  return value > 0.0f ? T(std::lround(std::min(value, 1.0f) * full)) : T(0);  // NaN is 0 too
}

OIIO::TypeDesc type_of(ImageModule::Storage storage) {
  switch (storage) {
    case ImageModule::Storage::float32:
      return OIIO::TypeFloat;
    case ImageModule::Storage::bits8:
      return OIIO::TypeUInt8;
    case ImageModule::Storage::bits16:
      return OIIO::TypeUInt16;
  }
  return OIIO::TypeFloat;
}

OIIO::ImageSpec spec_of(const PictureShape& shape, ImageModule::Storage storage) {
  OIIO::ImageSpec spec(shape.cols, shape.rows, shape.channels, type_of(storage));
  if (shape.channels == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("png:compressionLevel", 1);          // three times as fast, a tenth larger
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // else TIFF remembers the time of writing
  return spec;
}

// Band by band; T is how a value is stored.
template <class T>
bool write_pixels(OIIO::ImageOutput& output, const RowSource& source, const auto& stored) {
  const OIIO::ImageSpec& spec = output.spec();
  const int band = std::min(rows_of_band(spec), spec.height);
  const std::size_t in_row = std::size_t(spec.width) * std::size_t(spec.nchannels);
  std::vector<float> values(in_row);
  std::vector<T> pixels(std::size_t(band) * in_row);
  for (int begin = 0; begin < spec.height; begin += band) {
    const int end = std::min(begin + band, spec.height);
    T* to = pixels.data();
    for (int row = begin; row < end; ++row) {
      source(row, values.data());
      to = std::transform(values.begin(), values.end(), to, stored);
    }
    if (!output.write_scanlines(begin, end, 0, spec.format, pixels.data())) return false;
  }
  return true;
}

bool write_pixels(OIIO::ImageOutput& output, const RowSource& source,
                  ImageModule::Storage storage) {
  switch (storage) {
    case ImageModule::Storage::float32:
      return write_pixels<float>(output, source, [](float value) { return value; });
    case ImageModule::Storage::bits8:
      return write_pixels<std::uint8_t>(output, source, as_integer<std::uint8_t>);
    case ImageModule::Storage::bits16:
      return write_pixels<std::uint16_t>(output, source, as_integer<std::uint16_t>);
  }
  return false;
}

std::string write(const std::string& path, int threads, const PictureShape& shape,
                  ImageModule::Storage storage, const RowSource& row,
                  std::vector<std::uint8_t>* bytes) noexcept try {
  use_threads(threads);
  const auto output = OIIO::ImageOutput::create(path);
  OIIO::Filesystem::IOVecOutput memory;
  bool good = output != nullptr;
  if (good && bytes) good = output->set_ioproxy(&memory);
  good = good && output->open(path, spec_of(shape, storage));
  good = good && write_pixels(*output, row, storage);
  good = output && output->close() && good;
  std::string why = reason(output);
  // OpenImageIO 2.4 complains so of every TIFF, whose pixels are then written nevertheless.
  if (good && why.find("Exif") != std::string::npos) why.clear();
  if (bytes) *bytes = memory.buffer();
  if (good && why.empty()) return "";
  return "cannot be written" + (why.empty() ? "" : " (" + why + ")") +
         "; check the free space and the rights of the folder";
} catch (const std::exception& error) {
  return "cannot be written (" + first_line(error.what()) + ")";
}

}  // namespace
}  // namespace hada

extern "C" __attribute__((visibility("default")))
const hada::ImageModule hada_image_module = {hada::read, hada::write};
