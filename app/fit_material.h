#pragma once

#include <string>
#include <vector>

#include "app/material_file.h"
#include "core/surface.h"
#include "fit/fit.h"
#include "fit/forged.h"
#include "fit/knit_photographs.h"

namespace hada {

/// Photographs of a knit that is pulled, and what they tell.
struct PulledKnitInput {
  std::vector<KnitPhotograph> photographs;
  KnitPiece piece;
  PulledKnitFit found = {};  // filled by the fit
};

struct FitMaterialOptions {
  int components = 0;         // of a material that has a list of them; 0: the data decide
  double lens_blur_px = 0.0;  // of wrinkles: what the lens is known to blur by, standard deviation
  bool ridges = false;        // of wrinkles: whether skew, tail and sharpness are found too
  std::string view = "automatic";     // or, of wood, end-grain or face; of forged steel, block
  const Surface* face = nullptr;      // of wood: the tangential face of the block, beside its end
  PulledKnitInput* pulled = nullptr;  // of knit: photographs of it pulled, where they are
  ForgedFit* forged = nullptr;        // of forged steel: where all that was found is kept
  FitProgress progress = {};          // told what is being done, where a fit has stages
};

/// The material `name` that explains `surface` best.
///
/// Each material looks at what it explains: wrinkles at the height (at the brightness, with a
/// remark, where there is none), wood, knit and forged steel at the albedo. input_name  what the
/// surface was read from, for the record
MaterialFile fit_material(const std::string& name, const Surface& surface,
                          const std::string& input_name, const FitMaterialOptions& options = {});

}  // namespace hada
