#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/srgb.h"

/// Images on disk, all formats, by OpenImageIO: a module that is loaded when the first image is
/// touched, because linking it would make every start of the program ten times slower.
namespace hada {

/// A picture as its file holds it: integers scaled so that the largest is 1, floats as they are.
struct ImageFile {
  Image image;            // one plane or three; an alpha channel is left out
  int bits = 8;           // of one value
  bool floating = false;  // half or float
};

/// What a file says of its picture.
struct PictureShape {
  int rows = 0;
  int cols = 0;
  int channels = 1;  // one or three
  int bits = 8;      // of one value
  bool floating = false;
};

/// What becomes of a picture that is read row by row, from the top; values as in `ImageFile`, those
/// of a pixel side by side.
struct RowReader {
  std::function<bool(const PictureShape& shape)> begin;  // whether to go on
  std::function<void(int row, const float* pixels)> row;
};

/// Gives row `row` of a picture that is written from the top, the values of a pixel side by side.
using RowSource = std::function<void(int row, float* pixels)>;

/// Reads a picture that need not fit into memory.
/// throws  what `read_image` does, and what `reader` throws
void read_rows(const std::filesystem::path& path, const RowReader& reader);

/// throws  Error if the file is missing, unreadable, truncated, not an image, empty, deeper than a
///         picture (volume, tiles of 3-D) or larger than 2^28 pixels
ImageFile read_image(const std::filesystem::path& path);

/// Whether the name ends like an image that `read_image` may understand.
bool has_image_name(const std::filesystem::path& path);

/// Writes float planes as EXR (32-bit, lossless ZIP). One plane is named Y, three R, G, B.
///
/// These writers take the path of a scratch file (see `Output`) and replace nothing by themselves.
/// throws  Error if the file cannot be written
void write_exr(const std::filesystem::path& path, const Image& image);

/// The same files from rows that need not fit into memory at once; `row` throws nothing.
void write_exr_rows(const std::filesystem::path& path, const PictureShape& shape,
                    const RowSource& row);
void write_integer_rows(const std::filesystem::path& path, const PictureShape& shape, int bits,
                        const RowSource& row);

/// Writes planes with values in [0, 1] (clipped) as integers of 8 or 16 bits; `path` ends in .png,
/// .tif or .tiff. The values are stored as they are: encode for the eye before.
void write_integer_image(const std::filesystem::path& path, const Image& image, int bits);

/// The bytes of an 8-bit PNG with these values (clipped to [0, 1]).
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace hada
