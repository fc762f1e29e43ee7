#pragma once

#include "core/image.h"
#include "core/surface.h"

/// Maps as pictures for the eye: values with the sRGB curve on, ready for `encode_png`.
namespace hada {

struct Range {
  double low = 0.0;
  double high = 1.0;
};

/// The range of the values inside `mask` without the outermost `tail` share at each end; never
/// empty.
Range range_of(const Grid<float>& values, const Mask& mask, double tail = 0.002);

/// How a relief is drawn. Reliefs that are compared share one style.
struct ReliefStyle {
  Range height;               // of the colours, in the surface's unit
  double exaggeration = 1.0;  // of the slopes in the shading
};

/// Colours over the whole height, slopes exaggerated until their root mean square is steep enough
/// to be seen.
ReliefStyle relief_style(const Surface& surface);

/// The height in colour, shaded by a light from the upper left.
Image relief_picture(const Surface& surface, const ReliefStyle& style);

/// A surface shrunk by whole pixels until no side is longer than `most_px`: each pixel the mean of
/// those inside the mask that it covers, of height and normals; what else there is, is left out.
Surface shrunk(const Surface& surface, int most_px);

/// Normals as colours: (n + 1) / 2, y up.
Image normal_picture(const Surface& surface);

/// The albedo as an eye sees it, its 99.5 % point four fifths of white.
Image albedo_picture(const Surface& surface);

/// One quantity in the sequential palette.
Image scalar_picture(const Grid<float>& values, const Mask& mask, Range range);

/// A linear photograph for the eye, no side longer than `most_px`, each pixel the mean of those it
/// covers.
Image thumbnail(const Image& photograph, bool linear, int most_px);

/// A picture shrunk by whole pixels until no side is longer than `most_px`.
Image shrunk(const Image& picture, int most_px);

}  // namespace hada
