#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fit/block.h"

namespace hada {

/// A place where a block is or shall be cut.
struct NamedCut {
  std::string name;
  Cut cut;
  Extent extent;
};

/// A block as it is kept in a file (`"hada": "block/1"`): pictures of its faces and where these
/// lie, and cuts that are asked for.
struct BlockFile {
  std::vector<PlacedFace> faces;
  std::vector<NamedCut> cuts;
};

/// throws  Error naming the file and the key for what is missing, unknown or cannot be
BlockFile read_block(const std::filesystem::path& path);

}  // namespace hada
