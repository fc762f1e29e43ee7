#include "io/whole_file.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hada {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n"sv;
constexpr std::string_view jpeg_signature = "\xff\xd8\xff"sv;
constexpr std::string_view tiff_signatures[] = {"II\x2a\0"sv, "MM\0\x2a"sv};

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

std::uint64_t little_endian(std::string_view bytes, std::size_t start, int count) {
  std::uint64_t value = 0;
  for (int i = count; i-- > 0;) value = value << 8 | byte_at(bytes, start + std::size_t(i));
  return value;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t start, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8 | byte_at(bytes, start + std::size_t(i));
  return value;
}

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t rest = i;
    for (int bit = 0; bit < 8; ++bit) rest = rest & 1u ? 0xedb88320u ^ rest >> 1 : rest >> 1;
    table[i] = rest;
  }
  return table;
}();

std::uint32_t crc(std::string_view bytes) {
  std::uint32_t rest = 0xffffffffu;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    rest = crc_table[(rest ^ byte_at(bytes, i)) & 0xffu] ^ rest >> 8;
  }
  return ~rest;
}

// Chunks: length, four letters, data, the sum of letters and data; the last is called IEND.
bool is_whole_png(std::string_view bytes) {
  constexpr std::size_t around = 12;
  std::size_t at = png_signature.size();
  while (bytes.size() - at >= around) {
    const std::size_t length = big_endian(bytes, at, 4);
    if (length > bytes.size() - at - around) return false;
    const std::string_view summed = bytes.substr(at + 4, 4 + length);
    if (crc(summed) != big_endian(bytes, at + 8 + length, 4)) return false;
    if (summed.substr(0, 4) == "IEND") return true;
    at += around + length;
  }
  return false;
}

// Segments: 0xff, a marker, and for most a length with its data. The compressed scan that follows
// a segment is passed over by looking for the next 0xff that begins a marker other than a restart.
bool is_whole_jpeg(std::string_view bytes) {
  constexpr std::uint32_t end_of_image = 0xd9;
  const auto is_marker = [](std::uint32_t code) {
    return code != 0x00 && code != 0x01 && code != 0xff && !(code >= 0xd0 && code <= 0xd7);
  };
  std::size_t at = 2;
  while (at + 1 < bytes.size()) {
    const std::uint32_t code = byte_at(bytes, at + 1);
    if (byte_at(bytes, at) != 0xff || !is_marker(code)) {
      ++at;
    } else if (code == end_of_image) {
      return true;
    } else {
      if (at + 4 > bytes.size()) return false;
      at += 2 + big_endian(bytes, at + 2, 2);
    }
  }
  return false;
}

// The first directory, which says where all else lies; most programs write it last.
bool is_whole_tiff(std::string_view bytes) {
  constexpr std::size_t head = 8;
  if (bytes.size() < head) return false;
  const bool little = bytes[0] == 'I';
  const std::uint64_t at = little ? little_endian(bytes, 4, 4) : big_endian(bytes, 4, 4);
  return at >= head && at + 2 <= bytes.size();
}

}  // namespace

bool is_whole(std::string_view bytes) {
  if (bytes.starts_with(png_signature)) return is_whole_png(bytes);
  if (bytes.starts_with(jpeg_signature)) return is_whole_jpeg(bytes);
  for (const auto& signature : tiff_signatures) {
    if (bytes.starts_with(signature)) return is_whole_tiff(bytes);
  }
  return true;
}

}  // namespace hada
