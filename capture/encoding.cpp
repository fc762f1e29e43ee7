#include "capture/encoding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "capture/equalized.h"
#include "core/quantile.h"
#include "core/srgb.h"

namespace hada {
namespace {

constexpr std::size_t fewest_lights = 4;  // with three nothing is left over

// The share of the brightness of bright pixels that no Lambertian surface under these lights shows.
//
// linear  but for a curve that `decode` takes off
template <class Decode>
double unexplained(const Photographs& linear, const std::vector<Light>& lights,
                   const Decode& decode) {
  const std::size_t size = linear.images.front().planes.front().size();
  const std::size_t stride = std::max<std::size_t>(1, size / 20000);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < size; i += stride) {
    if (linear.mask.empty() || linear.mask[i]) chosen.push_back(i);
  }
  const auto count = Eigen::Index(lights.size());
  Eigen::MatrixX3d directions(count, 3);
  Eigen::MatrixXd all_values(count, Eigen::Index(chosen.size()));
  for (Eigen::Index k = 0; k < count; ++k) {
    const Image& image = linear.images[std::size_t(k)];
    const Light& light = lights[std::size_t(k)];
    directions.row(k) = light.direction;
    for (std::size_t p = 0; p < chosen.size(); ++p) {
      all_values(k, Eigen::Index(p)) = equalized(image, light, chosen[p], decode);
    }
    image.let_go();
  }
  const Eigen::MatrixXd inverse = directions.completeOrthogonalDecomposition().pseudoInverse();
  std::vector<std::pair<double, double>> pixels;  // brightness, residual
  for (Eigen::Index p = 0; p < all_values.cols(); ++p) {
    const Eigen::VectorXd values = all_values.col(p);
    const double residual = (values - directions * (inverse * values)).norm();
    pixels.emplace_back(values.norm(), residual);
  }
  if (pixels.empty()) return 0.0;
  std::sort(pixels.begin(), pixels.end());
  std::vector<double> shares;
  for (std::size_t i = pixels.size() / 2; i < pixels.size(); ++i) {
    shares.push_back(pixels[i].second / std::max(pixels[i].first, 1e-12));
  }
  return median(std::move(shares));
}

// The same of pictures as loaded, read as linear or with the sRGB curve.
double unexplained(const Photographs& photographs, const std::vector<Light>& lights,
                   bool as_linear) {
  const CaptureFile& file = photographs.file;
  if (file.dark || file.ambient || file.flat ||
      has_vignetting(file)) {  // they come between curve and brightness
    Photographs read = copy_of(photographs);
    read.linear = as_linear;
    return unexplained(linearized(std::move(read)), lights, [](float value) { return value; });
  }
  if (as_linear) return unexplained(photographs, lights, [](float value) { return value; });
  return unexplained(photographs, lights, [](float value) { return linear_from_srgb(value); });
}

}  // namespace

void settle_encoding(Photographs& photographs, const std::vector<Light>& lights) {
  if (photographs.encoding_known) return;
  if (lights.size() < fewest_lights) {
    photographs.remarks.push_back(
        "Too few pictures to tell how the 8-bit values are encoded; sRGB is assumed (say "
        "\"encoding\" in capture.json if it is not).");
    return;
  }
  const double linear = unexplained(photographs, lights, true);
  const double srgb = unexplained(photographs, lights, false);
  photographs.linear = linear <= srgb;
  photographs.encoding_known = true;
  photographs.remarks.push_back(fmt::format(
      "The 8-bit pictures are read as {}: that leaves {:.1f} % of the brightness unexplained, the "
      "other reading {:.1f} %.",
      photographs.linear ? "linear" : "sRGB", 100.0 * std::min(linear, srgb),
      100.0 * std::max(linear, srgb)));
}

std::optional<std::string> doubt_of_linear(const Photographs& photographs,
                                           const std::vector<Light>& lights) {
  constexpr double notable = 0.05;  // of the brightness
  constexpr double far_better = 1.0 / 3.0;
  if (!photographs.linear || lights.size() < fewest_lights) return {};
  const double linear = unexplained(photographs, lights, true);
  if (linear < notable) return {};
  const double srgb = unexplained(photographs, lights, false);
  if (srgb > far_better * linear) return {};
  return fmt::format(
      "The pictures are read as linear, but with the sRGB curve undone the lights leave {:.1f} % "
      "of the brightness unexplained, as they are {:.1f} %: say \"encoding\": \"srgb\" in "
      "capture.json, or develop them without a tone curve.",
      100.0 * srgb, 100.0 * linear);
}

}  // namespace hada
