#pragma once

#include <vector>

#include "core/image.h"
#include "mechanics/knit_net.h"

namespace hada {

/// A flat net drawn as lines, nylon light blue and support yarn dark, pinned points orange; states
/// side by side at one scale, with a scale bar.
Image net_picture(const KnitNet& net, const std::vector<Places>& states, int rows = 420);

}  // namespace hada
