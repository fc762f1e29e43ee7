#pragma once

#include "core/bounding_box.h"
#include "core/surface.h"

namespace hada {

/// The brightness of a part of a picture.
Surface piece_of(const Surface& picture, const PixelBox& box);

/// How near a synthesised texture comes to a picture, by their spectra.
struct TextureScore {
  double distance_db = 0.0;  // of a synthesis with the fitted wrinkles
  double floor_db = 0.0;     // of a synthesis with the very spectrum of the picture, phases drawn
  double std_ratio = 0.0;    // of the brightness, fitted over measured
};

/// Fits wrinkles of `components` noise functions to the brightness of `picture` and makes as much
/// of it again.
///
/// A distance is the root mean square over the whole square of frequencies, in patches of 4 x 4
/// ordinates of Hann-tapered periodograms, of the difference of 10 log10: chance alone leaves 3 dB.
TextureScore study_texture(const Surface& picture, int components);

}  // namespace hada
