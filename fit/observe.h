#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/surface.h"
#include "fit/cells.h"
#include "measure/spectrum.h"

namespace hada {

/// What the wrinkle fit looks at.
struct Observation {
  Spectrum spectrum;
  /// Under a stronger taper, which hides less behind its leakage and knows less of the rest, where
  /// leakage of the usual one hides much; `coarse` and `fine` are then cut from this.
  std::optional<Spectrum> steep;
  std::vector<Cell> coarse;
  std::vector<Cell> fine;    // to where aliases may begin
  std::vector<Cell> full;    // to the Nyquist frequency
  std::vector<Cell> whole;   // the same without those that hold much leakage; of pictures alone
  std::vector<Cell> square;  // to the corners, where fx and fy are both Nyquist's
  std::string levelling = "offset";  // of the heights, as `Surface` tells it
  std::vector<std::string> remarks;

  /// What `coarse` and `fine` are cut from.
  const Spectrum& of_starts() const { return steep ? *steep : spectrum; }
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
