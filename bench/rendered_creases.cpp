#include "bench/rendered_creases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/lit_capture.h"
#include "io/json_light.h"
#include "measure/creases.h"
#include "reconstruct/reconstruct.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr double degree = std::numbers::pi / 180.0;

Vector2d pixel_from(const Json& numbers) {
  return {double(numbers[0]), double(numbers[1])};
}

}  // namespace

RenderedCreases rendered_creases(const std::filesystem::path& scene) {
  const Terminal terminal({.quiet = true});
  const LitCapture lit = lit_capture(load_folder(scene / "images", terminal), {}, terminal);
  const Surface seen = reconstruct(lit.stack).surface;
  const MeasuredCreases found = measured_creases(seen, {}, &lit.stack);
  const auto pixel_of = [&](const Vector2d& place) {
    const Vector2d pixel = seen.extent.pixel(place);
    return Vector2d(pixel.y() + 0.5 + seen.offset_px.x(), pixel.x() + 0.5 + seen.offset_px.y());
  };
  RenderedCreases score;
  const Json truth = read_plain_json(scene / "truth" / "truth.json");
  for (const Json& crease : truth["creases"]) {
    ++score.creases;
    const double fold = double(crease["deviation_from_flat_deg"]) *
                        (std::string(crease["kind"]) == "valley" ? 1.0 : -1.0);
    const Vector2d from = pixel_from(crease["ends_px"][0]), to = pixel_from(crease["ends_px"][1]);
    const Vector2d way = (to - from).normalized(), across(-way.y(), way.x());
    for (const MeasuredCrease& measured : found.creases) {
      const double off = std::max(std::abs(across.dot(pixel_of(measured.from) - from)),
                                  std::abs(across.dot(pixel_of(measured.to) - from)));
      if (off > 5.0) continue;
      ++score.found;
      const double error = std::abs(measured.fold_angle / degree - fold);
      score.worst_deg = std::max(score.worst_deg, error);
      score.worst_line_px = std::max(score.worst_line_px, off);
      score.worst_sigmas = std::max(score.worst_sigmas, error * degree / measured.fold_angle_sigma);
    }
  }
  return score;
}

}  // namespace hada
