#pragma once

#include "core/image.h"
#include "fit/block_cut.h"

namespace hada {

/// `ground`, a picture for the eye of the same size, with the ring lines of a cut drawn into it:
/// where each is expected, and within a band where it is with 90 % certainty.
Image cut_picture(Image ground, const CutPrediction& cut);

/// Two pictures of one height side by side.
Image beside(const Image& left, const Image& right);

}  // namespace hada
