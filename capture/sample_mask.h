#pragma once

#include <optional>
#include <vector>

#include "core/grid.h"
#include "core/sphere.h"
#include "io/capture_file.h"

namespace hada {

/// Where the sample is: the largest region that is brighter than the table and no sphere.
///
/// The picture is parted into bright and dark by the threshold that separates the logarithms of its
/// values best; dark prints inside the region belong to it; its border, where a pixel sees both
/// sample and table, is taken off. If bright and dark differ by less than a factor of three there
/// is no table: everything but the spheres is the sample.
///
/// brightness  linear, the mean of pictures that are lit from several sides
/// box         where to look, roughly
/// returns     an empty grid if nothing covers at least 1 % of the picture
///
/// Source of the threshold: Otsu, IEEE Trans. SMC 9 (1979).
Mask sample_mask(const Grid<float>& brightness, const std::vector<Sphere>& spheres,
                 const std::optional<BoxPx>& box);

}  // namespace hada
