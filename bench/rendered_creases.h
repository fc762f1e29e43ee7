#pragma once

#include <filesystem>

namespace hada {

/// The creases of a rendered sheet, measured from its pictures alone.
struct RenderedCreases {
  int creases = 0;  // that are true
  int found = 0;
  double worst_deg = 0.0;      // of the fold angles
  double worst_line_px = 0.0;  // of the ends that were found, from the true lines
  double worst_sigmas = 0.0;   // of the fold angles, in their own sigma
};

/// scene  a folder with images/ and truth/truth.json, as rendered/paper_creased
RenderedCreases rendered_creases(const std::filesystem::path& scene);

}  // namespace hada
