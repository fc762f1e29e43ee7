#include "synth/painted.h"

#include <algorithm>
#include <cassert>

#include "core/srgb.h"

namespace hada {

Surface painted(Surface drawn, const std::vector<double>& mean_albedo) {
  if (mean_albedo.empty()) return drawn;
  assert(mean_albedo.size() == 1 || mean_albedo.size() == 3);
  const std::vector<double>& mean = mean_albedo;
  const double middle = mean.size() == 1
                            ? mean[0]
                            : luminance_weight[0] * mean[0] + luminance_weight[1] * mean[1] +
                                  luminance_weight[2] * mean[2];
  assert(middle > 0.0);
  const float brightness = srgb_from_linear(float(middle));
  drawn.albedo = Image(drawn.extent.rows, drawn.extent.cols, int(mean.size()));
  for (std::size_t i = 0; i < drawn.height.size(); ++i) {
    const float luminance = linear_from_srgb(std::max(0.0f, brightness + drawn.height[i]));
    for (std::size_t c = 0; c < mean.size(); ++c) {
      drawn.albedo.planes[c][i] = float(mean[c] / middle * double(luminance));
    }
  }
  drawn.height = {};
  drawn.normals = {};
  return drawn;
}

}  // namespace hada
