#include "capture/diagnose.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "capture/agreement.h"
#include "capture/lit_disc.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double notable_share = 0.01;  // of saturated pixels

double slant_of(const Light& light) {
  return std::acos(std::clamp(light.direction.z(), -1.0, 1.0));
}

// The widest gap between neighbouring lights around the sample; 0 if fewer than two have a side.
double widest_gap(const std::vector<Light>& lights) {
  std::vector<double> turns;
  constexpr double overhead = 10.0 * degree;
  for (const Light& light : lights) {
    if (slant_of(light) < overhead) continue;
    turns.push_back(std::atan2(light.direction.y(), light.direction.x()));
  }
  if (turns.size() < 2) return 0.0;
  std::sort(turns.begin(), turns.end());
  double widest = turns.front() + 2.0 * std::numbers::pi - turns.back();
  for (std::size_t i = 1; i < turns.size(); ++i) {
    widest = std::max(widest, turns[i] - turns[i - 1]);
  }
  return widest;
}

void remark_on_height(const std::vector<Light>& lights, std::vector<std::string>& remarks) {
  const auto [lowest, highest] = std::minmax_element(
      lights.begin(), lights.end(),
      [](const Light& a, const Light& b) { return a.direction.z() < b.direction.z(); });
  constexpr double frontal = 20.0 * degree;
  constexpr double grazing = 70.0 * degree;
  if (slant_of(*lowest) < frontal) {
    remarks.push_back(fmt::format(
        "All lights come from within {:.0f} degrees of the camera's axis, where slopes hardly "
        "change the brightness; put some of them 30 to 60 degrees above the table.",
        slant_of(*lowest) / degree));
  } else if (slant_of(*highest) > grazing) {
    remarks.push_back(fmt::format(
        "All lights graze the table (the highest stands {:.0f} degrees above it), so that much of "
        "the sample is in shadow; put some of them 30 to 60 degrees above the table.",
        90.0 - slant_of(*highest) / degree));
  }
}

void remark_on_sides(const std::vector<Light>& lights, std::vector<std::string>& remarks) {
  const double gap = widest_gap(lights) / degree;
  constexpr double half_turn_and_some = 190.0;
  if (gap < half_turn_and_some) return;
  remarks.push_back(fmt::format(
      "All lights come from one side (over {:.0f} degrees around the sample there is none), so "
      "that slopes away from them are poorly seen; spread them all around.",
      gap));
}

void remark_on_twins(const std::vector<Light>& lights, std::vector<std::string>& remarks) {
  constexpr double nearly_the_same = 2.0 * degree;
  std::size_t pairs = 0;
  std::string first;
  for (std::size_t a = 0; a < lights.size(); ++a) {
    for (std::size_t b = a + 1; b < lights.size(); ++b) {
      const double apart =
          2.0 * std::asin(std::min(1.0, 0.5 * (lights[a].direction - lights[b].direction).norm()));
      if (apart > nearly_the_same || pairs++ > 0) continue;
      first = fmt::format("{} and {} have nearly the same light ({:.1f} degrees apart",
                          lights[a].image, lights[b].image, apart / degree);
    }
  }
  if (pairs == 0) return;
  if (pairs > 1) first += fmt::format("; {} more pairs as well", pairs - 1);
  remarks.push_back(first +
                    "), so that the second shows nothing new; move the lamp between pictures.");
}

// "the matte sphere at (412, 96)"
std::string place_of(const Sphere& sphere) {
  return fmt::format("the {} sphere at ({:.0f}, {:.0f})", name_of(sphere.kind),
                     sphere.center_px.x(), sphere.center_px.y());
}

std::string capitalized(std::string sentence) {
  sentence[0] = char(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

// "a.png", "a.png and b.png", "a.png, b.png and 3 more"
std::string listed(const std::vector<std::string>& names) {
  if (names.size() == 1) return names[0];
  if (names.size() == 2) return names[0] + " and " + names[1];
  return fmt::format("{}, {} and {} more", names[0], names[1], names.size() - 2);
}

void remark_on_sphere(const SphereReading& reading, std::vector<std::string>& remarks) {
  constexpr double small_px = 15.0;
  if (reading.sphere.radius_px < small_px) {
    remarks.push_back(fmt::format(
        "The {} sphere is only {:.0f} px across; a larger one would give better lights.",
        name_of(reading.sphere.kind), 2.0 * reading.sphere.radius_px));
  }
  if (reading.misfit > 0.2) {
    remarks.push_back(fmt::format(
        "The matte sphere is not shaded like one ({:.0f} % of its contrast is unexplained): is it "
        "glossy, dirty, or lit by more than one lamp?",
        100.0 * reading.misfit));
  }
}

// The share of the sphere's disc that is saturated.
double clipped_share(const Mask& saturated, const Sphere& sphere) {
  const int reach = int(std::ceil(sphere.radius_px));
  double clipped = 0.0;
  double count = 0.0;
  for (int row = int(sphere.center_px.y()) - reach; row <= sphere.center_px.y() + reach; ++row) {
    for (int col = int(sphere.center_px.x()) - reach; col <= sphere.center_px.x() + reach; ++col) {
      const Eigen::Vector2d at(col + 0.5, row + 0.5);
      if (!saturated.contains(row, col) || (at - sphere.center_px).norm() > sphere.radius_px) {
        continue;
      }
      clipped += saturated(row, col) ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  return count > 0.0 ? clipped / count : 0.0;
}

// The pictures in which a sphere shows no light at all; of a matte one that lies in shadow there.
void remark_on_unseen(const Photographs& linear, const SphereReading& reading,
                      const std::vector<LitDisc>& discs, std::vector<std::string>& remarks) {
  std::vector<std::string> unseen;
  for (std::size_t k = 0; k < reading.lights.size(); ++k) {
    const bool odd = !discs.empty() && discs[k].light == DiscLight::odd;
    if (!std::isfinite(reading.lights[k].direction_sigma) && !odd) {
      unseen.push_back(linear.file.pictures[k].name);
    }
  }
  if (unseen.empty()) return;
  remarks.push_back(capitalized(place_of(reading.sphere)) + " shows no light in " + listed(unseen) +
                    ": it lies in shadow or is too dark there; move it into the light, or expose "
                    "more.");
}

// What single pictures show on a matte sphere, against the others: darkness, shadows, clipping.
void remark_on_pictures(const Photographs& linear, const SphereReading& reading,
                        const std::vector<LitDisc>& discs, std::vector<std::string>& remarks) {
  const std::string place = capitalized(place_of(reading.sphere));
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const std::string& name = linear.file.pictures[k].name;
    const bool asked = std::isfinite(reading.lights[k].direction_sigma);
    if (asked && discs[k].light == DiscLight::weak) {
      remarks.push_back(fmt::format(
          "{} is too dark in {} ({:.1f} % of the range): it lies in shadow, or the lamp is weak; "
          "move it into the light, or expose more.",
          place, name, 100.0 * discs[k].strength));
    } else if (discs[k].light == DiscLight::odd) {
      remarks.push_back(fmt::format(
          "{} is oddly lit in {} ({:.0f} % of its contrast is unexplained{}): a shadow lies on it, "
          "or a second lamp was on; photograph it again or leave the picture out.",
          place, name, 100.0 * discs[k].misfit, asked ? "" : ", so it is not asked there"));
    }
    const double clipped = clipped_share(linear.saturated[k], reading.sphere);
    if (asked && clipped > notable_share) {
      remarks.push_back(fmt::format("{} is clipped on {:.0f} % of its disc in {}; expose less.",
                                    place, std::ceil(100.0 * clipped), name));
    }
  }
}

}  // namespace

std::vector<std::string> remarks_on_lights(const std::vector<Light>& lights) {
  std::vector<std::string> remarks;
  if (lights.empty()) return remarks;
  remark_on_height(lights, remarks);
  remark_on_sides(lights, remarks);
  remark_on_twins(lights, remarks);
  return remarks;
}

std::vector<std::string> remarks_on_spheres(const Photographs& linear,
                                            const Calibration& calibration) {
  std::vector<std::string> remarks;
  for (const SphereReading& reading : calibration.readings) {
    remark_on_sphere(reading, remarks);
    std::vector<LitDisc> discs;
    if (reading.sphere.kind == SphereKind::matte) discs = lit_discs(linear, reading.sphere);
    remark_on_unseen(linear, reading, discs, remarks);
    remark_on_pictures(linear, reading, discs, remarks);
  }
  const auto agreement = remarks_on_agreement(calibration, linear.camera);
  remarks.insert(remarks.end(), agreement.begin(), agreement.end());
  return remarks;
}

std::vector<std::string> remarks_on_clipping(const LightStack& stack) {
  double worst = 0.0;
  std::vector<std::string> names;
  const auto area = double(std::count_if(stack.mask.begin(), stack.mask.end(),
                                         [](const auto inside) { return inside != 0; }));
  for (std::size_t k = 0; k < stack.samples.size(); ++k) {
    double clipped = 0.0;
    for (std::size_t i = 0; i < stack.mask.size(); ++i) {
      if (stack.mask[i] && stack.samples[k][i] == Sample::saturated) clipped += 1.0;
    }
    stack.samples[k].let_go();
    if (clipped <= notable_share * area) continue;
    names.push_back(stack.lights[k].image);
    worst = std::max(worst, clipped / area);
  }
  if (names.empty()) return {};
  return {fmt::format("The sample is clipped on up to {:.0f} % of its area in {}; expose less.",
                      std::ceil(100.0 * worst), listed(names))};
}

}  // namespace hada
