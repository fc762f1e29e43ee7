// hada_contact_sheet OUT.png COLUMNS MATERIAL.json ...: materials side by side, each 40 x 40 mm.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "app/material_file.h"
#include "core/error.h"
#include "io/image_file.h"
#include "synth/synthesize.h"

int main(int count, char** words) {
  if (count < 4) {
    std::fprintf(stderr, "usage: hada_contact_sheet OUT.png COLUMNS MATERIAL.json ...\n");
    return 2;
  }
  try {
    constexpr int side = 190, gap = 6;
    const int columns = std::max(1, std::atoi(words[2])), tiles = count - 3;
    const int lines = (tiles + columns - 1) / columns;
    hada::Image sheet(lines * (side + gap) + gap, columns * (side + gap) + gap, 3);
    for (auto& plane : sheet.planes) std::fill(plane.begin(), plane.end(), 1.0f);
    for (int tile = 0; tile < tiles; ++tile) {
      const auto file = hada::read_material(words[3 + tile]);
      const auto surface = hada::synthesize(
          file.material, {side, side, 40.0 / side, hada::Unit::mm}, file.seed.value_or(1));
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& plane = surface.albedo.planes[std::min(c, surface.albedo.planes.size() - 1)];
        for (int row = 0; row < side; ++row) {
          for (int col = 0; col < side; ++col) {
            sheet.planes[c](gap + tile / columns * (side + gap) + row,
                            gap + tile % columns * (side + gap) + col) =
                hada::srgb_from_linear(std::min(plane(row, col), 1.0f));
          }
        }
      }
    }
    hada::write_integer_image(words[1], sheet, 8);
  } catch (const hada::Error& error) {
    std::fprintf(stderr, "hada_contact_sheet: %s\n", error.what());
    return 2;
  }
  return 0;
}
