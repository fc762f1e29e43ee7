#pragma once

#include <string>
#include <vector>

#include "core/surface.h"
#include "fit/cells.h"
#include "measure/spectrum.h"

namespace hada {

/// What the wrinkle fit looks at.
struct Observation {
  Spectrum spectrum;
  std::vector<Cell> coarse;
  std::vector<Cell> fine;    // to where aliases may begin
  std::vector<Cell> full;    // to the Nyquist frequency
  std::vector<Cell> whole;   // the same without those that hold much leakage; of pictures alone
  std::vector<Cell> square;  // to the corners, where fx and fy are both Nyquist's
  std::string levelling = "offset";  // of the heights, as `Surface` tells it
  std::vector<std::string> remarks;
};

/// The spectrum of a surface in cells of three kinds. For a surface that comes from photographs,
/// what pixels and integration took from each wave is given back, and the noise of its normals,
/// which integration turns into slow waves, is known to every cell. What a lens took is given back
/// where it is known.
///
/// lens_blur_px  standard deviation of the lens's point spread, pixels; 0: none that matters
/// throws  Error if there is nothing to fit, or the mask is smaller than 32 x 32 pixels
Observation observe(const Surface& surface, double lens_blur_px = 0.0);

}  // namespace hada
