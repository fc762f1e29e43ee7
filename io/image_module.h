#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "io/image_file.h"

namespace hada {

/// What the module with OpenImageIO inside offers to `image_file.cpp`, and to nobody else.
///
/// Every function returns what went wrong, empty if nothing did; exceptions do not cross the door.
struct ImageModule {
  enum class Storage { float32, bits8, bits16 };

  std::string (*read)(const std::string& path, int threads, ImageFile& file) noexcept;
  /// `bytes`, where given, receives the file instead of the disk; `path` then only says the format.
  std::string (*write)(const std::string& path, int threads, const Image& image, Storage storage,
                       std::vector<std::uint8_t>* bytes) noexcept;
};

/// The name under which the module exports its ImageModule.
inline constexpr const char* image_module_symbol = "hada_image_module";

}  // namespace hada
