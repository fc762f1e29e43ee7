#include "app/commands/contact.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/draw/maps.h"
#include "app/files.h"
#include "app/material_file.h"
#include "core/error.h"
#include "io/output.h"
#include "synth/painted.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr int gap_px = 8;

Image picture_of(const std::filesystem::path& path, int width_px) {
  const MaterialFile file = read_material(path);
  Extent extent{512, 512, 1.0, file.unit};
  if (file.input && file.input->extent.rows > 0) extent = file.input->extent;
  const Surface surface =
      painted(synthesize(file.material, extent, file.seed.value_or(1)), file.mean_albedo);
  const int longest = std::max(1, width_px * std::max(extent.rows, extent.cols) / extent.cols);
  return shrunk(albedo_picture(surface), longest);
}

}  // namespace

void contact_command(const ContactArguments& arguments, const Terminal& terminal) {
  std::vector<Image> pictures;
  for (const auto& path : arguments.materials) {
    terminal.step("making " + path.string());
    pictures.push_back(picture_of(path, arguments.width_px));
  }
  if (pictures.empty()) throw Error("contact: no material files are given; name one or more");
  int rows = 0, cols = 0;
  for (const Image& picture : pictures) {
    rows = std::max(rows, picture.rows());
    cols = std::max(cols, picture.cols());
  }
  const int across = std::min(arguments.columns, int(pictures.size()));
  const int down = (int(pictures.size()) + across - 1) / across;
  Image sheet(down * (rows + gap_px) - gap_px, across * (cols + gap_px) - gap_px, 3);
  for (auto& plane : sheet.planes) std::fill(plane.begin(), plane.end(), 1.0f);
  for (int k = 0; k < int(pictures.size()); ++k) {
    const Image& picture = pictures[std::size_t(k)];
    const int top = k / across * (rows + gap_px), left = k % across * (cols + gap_px);
    for (std::size_t c = 0; c < 3; ++c) {
      for (int row = 0; row < picture.rows(); ++row) {
        const auto from = picture.planes[c].row(row);
        std::copy(from.begin(), from.end(),
                  sheet.planes[c].row(top + row).begin() + std::ptrdiff_t(left));
      }
    }
  }
  Output output(arguments.out.parent_path().empty() ? "." : arguments.out.parent_path());
  put_picture(output, arguments.out.filename().string(), sheet);
  output.commit();
  terminal.say(fmt::format("put {} pictures side by side", pictures.size()));
  terminal.say("wrote " + arguments.out.string());
}

}  // namespace hada
