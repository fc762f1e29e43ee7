#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "io/image_file.h"

namespace hada {

/// What the module with OpenImageIO inside offers to `image_file.cpp`, and to nobody else.
///
/// Every function returns what went wrong, empty if nothing did; its own exceptions do not cross
/// the door, and what it calls throws none.
struct ImageModule {
  enum class Storage { float32, bits8, bits16 };

  std::string (*read)(const std::string& path, int threads, const RowReader& reader) noexcept;
  /// `bytes`, where given, receives the file instead of the disk; `path` then only says the format.
  std::string (*write)(const std::string& path, int threads, const PictureShape& shape,
                       Storage storage, const RowSource& row,
                       std::vector<std::uint8_t>* bytes) noexcept;
};

/// The name under which the module exports its ImageModule.
inline constexpr const char* image_module_symbol = "hada_image_module";

}  // namespace hada
