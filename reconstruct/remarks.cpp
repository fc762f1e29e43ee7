#include "reconstruct/remarks.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/mean.h"
#include "core/quantile.h"
#include "reconstruct/regions.h"

namespace hada {
namespace {

// Where a person should hear of it.
constexpr double poor_condition = 8.0;    // noise reaches the worst axis eight times as strong
constexpr double poor_share_lost = 0.02;  // of the pixels of the mask
constexpr double poor_relighting_error = 0.10;  // a tenth of the picture is not explained
constexpr int few_inliers = 5;                  // two more than the unknowns
constexpr double odd_light = 3.0;               // times the typical error
constexpr std::size_t few_lights = 6;           // fewer, and one sheen or shadow decides a normal
constexpr double notable_turn = 0.003;          // rad, of normals by light that is not told
constexpr double notable_region = 0.01;         // of the pixels of the mask

std::ptrdiff_t pixels_in(const Mask& mask) {
  return std::count_if(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
}

std::string percent(double share) {
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.1 ? 1 : 0);
}

void remark_on_inliers(const Orientation& found, std::size_t lights,
                       std::vector<std::string>& remarks) {
  if (lights < few_lights) return;
  double few = 0.0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    few += found.mask[i] && found.inliers[i] < few_inliers;
  }
  const double share = few / double(std::max<std::ptrdiff_t>(1, pixels_in(found.mask)));
  if (share <= poor_share_lost) return;
  remarks.push_back(fmt::format(
      "At {} of the pixels fewer than {} samples agree, so one more that is wrong would turn the "
      "normal; more lights, or higher ones where shadows fall, would help.",
      percent(share), few_inliers));
}

// A light that the others contradict much more than they contradict each other.
void remark_on_lights(const LightStack& stack, const Orientation& found,
                      std::vector<std::string>& remarks) {
  if (found.light_errors.size() < few_lights) return;
  const double typical = median(found.light_errors);
  for (std::size_t k = 0; k < found.light_errors.size(); ++k) {
    const double error = found.light_errors[k];
    if (error < odd_light * typical || error < poor_relighting_error) continue;
    remarks.push_back(fmt::format(
        "The picture of light {} is off by {} from what the others predict (typical: {}); check "
        "that light, or leave the picture out.",
        stack.lights[k].image, percent(error), percent(typical)));
  }
}

void remark_on_terms(const Orientation& found, std::vector<std::string>& remarks) {
  const SharedTerms& terms = found.terms;
  if (terms.curved()) {
    const auto departure = [&](float u) {
      return u * (terms.curve[0] + u * (terms.curve[1] + u * terms.curve[2]));
    };
    remarks.push_back(fmt::format(
        "The surface is not quite matte: at 45 and at 70 degrees from the light it sends {:+.0f} % "
        "and {:+.0f} % of what Lambert's law says. One curve for all pixels was taken into "
        "account.",
        100.0f * departure(0.293f), 100.0f * departure(0.658f)));
  }
  if (terms.bounce > 0.0f) {
    remarks.push_back(fmt::format(
        "Light that the surface throws on itself was taken off; it is as strong as an albedo of "
        "{:.2f} would send.",
        double(terms.bounce) * mean(found.rho, found.mask)));
  } else if (found.untold_bounce > notable_turn) {
    remarks.push_back(fmt::format(
        "Light that folds throw on each other cannot be told from their shape in these pictures. "
        "If the surface sends half of it back, the normals are off by about {:.1f} deg, which "
        "their uncertainties do not know of; lower lights, whose shadows reach into the folds, "
        "would tell.",
        found.untold_bounce * 180.0 / std::numbers::pi));
  }
}

}  // namespace

std::vector<std::string> remarks_on(const LightStack& stack, const Orientation& found) {
  std::vector<std::string> remarks;
  const std::size_t lights = stack.lights.size();
  if (lights == 3) {
    remarks.push_back(
        fmt::format("With three lights nothing is left over to judge the noise by; the "
                    "uncertainties assume {} of the largest value. More lights would tell.",
                    found.noise));
  } else if (lights < few_lights) {
    remarks.push_back(
        fmt::format("There are only {} lights, so shadow and sheen can hardly be told from shape; "
                    "{} or more are better.",
                    lights, few_lights));
  }
  if (found.condition > poor_condition) {
    remarks.push_back(fmt::format(
        "The lights lie close to one plane (condition {:.1f}, 1 is ideal), so noise is "
        "strong in one direction; spread them around the sample, 30 to 60 degrees above "
        "the table.",
        found.condition));
  }
  const double lost = 1.0 - double(pixels_in(found.mask)) / double(pixels_in(stack.mask));
  if (lost > poor_share_lost) {
    remarks.push_back(fmt::format(
        "{} of the pixels of the mask have no normal: fewer than three good samples, "
        "or a normal that looks away. More lights, or a shorter exposure where pictures "
        "are saturated, would help.",
        percent(lost)));
  }
  if (found.left_out_error > poor_relighting_error) {
    remarks.push_back(fmt::format(
        "A matte surface under these lights leaves {} of the pictures unexplained: look "
        "for sheen, shadows, lights that are not those of the pictures, or pictures that are not "
        "linear. Samples that do not fit were left out where the estimator can.",
        percent(found.left_out_error)));
  }
  remark_on_inliers(found, lights, remarks);
  remark_on_lights(stack, found, remarks);
  remark_on_terms(found, remarks);
  if (auto remark = remark_on_regions(found.mask)) remarks.push_back(std::move(*remark));
  return remarks;
}

std::optional<std::string> remark_on_regions(const Mask& mask) {
  const Regions regions = regions_of(mask);
  const auto pixels = double(pixels_in(mask));
  const auto notable = std::count_if(regions.size.begin() + 1, regions.size.end(),
                                     [&](int size) { return size > notable_region * pixels; });
  if (notable < 2) return {};
  return fmt::format(
      "The mask has {} separate regions; how high they lie above one another is not known.",
      notable);
}

}  // namespace hada
