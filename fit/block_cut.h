#pragma once

#include <vector>

#include "fit/block.h"
#include "fit/face_grain.h"
#include "fit/ring_lines.h"

namespace hada {

/// How fibres lean at a place of a cut: steps to the right for each step up.
struct CutSlope {
  Eigen::Vector2d place;
  Known slope;
};

/// What a block that is known from other faces lets expect on a cut.
struct CutPrediction {
  Cut cut;
  Extent extent;
  std::vector<RingStation> rings;  // `sigma` as a distance across the line, in the unit of `extent`
  std::vector<CutSlope> slopes;    // none if the cut lies across the stem
  Known mean_slope;
  Surface picture;  // the albedo that a material can say
};

/// step_px  distance of the stations of a ring
CutPrediction predicted(const BlockFit& block, const Cut& cut, const Extent& extent,
                        int step_px = 4);

}  // namespace hada
