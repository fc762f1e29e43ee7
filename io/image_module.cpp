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

// Calls `put(row, pixels)` with so many rows at a time that what they take is small beside the
// picture; tiles come all at once. False where the file cannot be read.
template <class Put>
bool read_rows(OIIO::ImageInput& input, int first_channel, int channels, const Put& put) {
  const OIIO::ImageSpec spec = input.spec();
  const int rows_at_once = spec.tile_width > 0 ? spec.height : std::min(spec.height, 256);
  std::vector<float> pixels(std::size_t(spec.width) * std::size_t(rows_at_once * channels));
  for (int row = 0; row < spec.height; row += rows_at_once) {
    const int end = std::min(spec.height, row + rows_at_once);
    const bool good =
        rows_at_once == spec.height
            ? input.read_image(0, 0, first_channel, first_channel + channels, OIIO::TypeFloat,
                               pixels.data())
            : input.read_scanlines(0, 0, spec.y + row, spec.y + end, spec.z, first_channel,
                                   first_channel + channels, OIIO::TypeFloat, pixels.data());
    if (!good) return false;
    for (int r = row; r < end; ++r) {
      put(r, pixels.data() + std::size_t(r - row) * std::size_t(spec.width * channels));
    }
  }
  return true;
}

std::string read_open_file(OIIO::ImageInput& input, const std::string& path, ImageFile& file) {
  const OIIO::ImageSpec& spec = input.spec();
  if (auto problem = size_problem(spec, path); !problem.empty()) return problem;
  const std::vector<int> channels = picture_channels(spec);
  if (channels.empty()) {
    return "has " + std::to_string(spec.nchannels) +
           " channels and none named Y or R, G, B; export grey or colour";
  }

  const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
  const int stride = *last - *first + 1;
  file.image = Image(spec.height, spec.width, int(channels.size()));
  const bool good = read_rows(input, *first, stride, [&](int row, const float* pixels) {
    for (std::size_t plane = 0; plane < channels.size(); ++plane) {
      const float* source = pixels + (channels[plane] - *first);
      for (float& value : file.image.planes[plane].row(row)) {
        value = *source;
        source += stride;
      }
    }
  });
  if (!good) return damaged(first_line(input.geterror()));
  file.floating = spec.format.is_floating_point();
  file.bits = bits_of(spec, file.floating);
  return "";
}

std::string read(const std::string& path, int threads, ImageFile& file) noexcept try {
  use_threads(threads);
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, not multiplied by alpha
  wishes.attribute("raw:ColorSpace", "sRGB-linear");
  wishes.attribute("raw:auto_bright", 0);
  wishes.attribute("raw:user_flip", 0);
  const auto input = OIIO::ImageInput::open(path, &wishes);
  const std::string why = reason(input);
  if (!input) return "is not a picture that can be read; export it as PNG, TIFF, JPEG or EXR";
  std::string problem = read_open_file(*input, path, file);
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
std::vector<T> interleaved(const Image& image, const auto& stored) {
  const std::size_t channels = image.planes.size();
  std::vector<T> pixels(image.planes.front().size() * channels);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < image.planes[c].size(); ++i) {
      pixels[i * channels + c] = stored(image.planes[c][i]);
    }
  }
  return pixels;
}

template <class T>
T as_integer(float value) {
  constexpr float full = std::numeric_limits<T>::max();
  return value > 0.0f ? T(std::lround(std::min(value, 1.0f) * full)) : T(0);  // NaN is 0 too
}

OIIO::ImageSpec spec_of(const Image& image, ImageModule::Storage storage) {
  const auto type = storage == ImageModule::Storage::float32 ? OIIO::TypeDesc::FLOAT
                    : storage == ImageModule::Storage::bits8 ? OIIO::TypeDesc::UINT8
                                                             : OIIO::TypeDesc::UINT16;
  OIIO::ImageSpec spec(image.cols(), image.rows(), image.channels(), type);
  if (image.channels() == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // else TIFF remembers the time of writing
  return spec;
}

bool write_pixels(OIIO::ImageOutput& output, const Image& image, ImageModule::Storage storage) {
  if (storage == ImageModule::Storage::float32) {
    const auto pixels = interleaved<float>(image, [](float value) { return value; });
    return output.write_image(OIIO::TypeFloat, pixels.data());
  }
  if (storage == ImageModule::Storage::bits8) {
    const auto pixels = interleaved<std::uint8_t>(image, as_integer<std::uint8_t>);
    return output.write_image(OIIO::TypeUInt8, pixels.data());
  }
  const auto pixels = interleaved<std::uint16_t>(image, as_integer<std::uint16_t>);
  return output.write_image(OIIO::TypeUInt16, pixels.data());
}

std::string write(const std::string& path, int threads, const Image& image,
                  ImageModule::Storage storage, std::vector<std::uint8_t>* bytes) noexcept try {
  use_threads(threads);
  const auto output = OIIO::ImageOutput::create(path);
  OIIO::Filesystem::IOVecOutput memory;
  bool good = output != nullptr;
  if (good && bytes) good = output->set_ioproxy(&memory);
  good = good && output->open(path, spec_of(image, storage));
  good = good && write_pixels(*output, image, storage);
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
