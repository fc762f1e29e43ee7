#pragma once

#include <vector>

#include "core/light_stack.h"
#include "reconstruct/bounce.h"
#include "reconstruct/tile.h"

namespace hada {

struct NormalOptions;

/// Where the samples of a tile come from, and how they are made ready.
struct TileSource {
  const LightStack& stack;
  float channel_weight[3] = {1.0f, 0.0f, 0.0f};  // of a grey value; sum 1
  bool all_count = false;                        // shadowed and saturated samples too
  const Grid<float>* height = nullptr;           // of the points, for near lights; none: 0
  const Bounce* bounce = nullptr;

  bool near() const;

  /// A tile that fits this source; `keep_raw` for shared terms, which are taken off `raw`.
  Tile tile(int most_pixels, bool keep_raw) const;

  /// Puts `count` pixels of a row, from `col` on, into the tile at pixel `first`.
  ///
  /// returns  whether every one of these samples may count
  bool fill(Tile& tile, int first, int row, int col, int count) const;

  /// The rows [begin, end) have been read: those of pictures on disk may leave the memory.
  void let_go(int begin, int end) const;

  /// Whether grey values can be read off the pictures: one channel, distant lights.
  bool reads_directly() const;

  /// The pixels of a row from `col` on, for sources that can be read directly.
  void point_at_row(int row, int col, GreyRows& rows) const;

  /// One channel of the pixels that `fill` put at 0, strength and fall-off divided out, in the
  /// order of tile.grey.
  void fill_channel(const Tile& tile, int channel, int row, int col,
                    std::vector<float>& values) const;
};

/// The samples as the estimator of `options` wants them.
TileSource source_of(const LightStack& stack, const NormalOptions& options);

}  // namespace hada
