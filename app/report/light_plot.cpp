#include "app/report/light_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/report/html.h"

namespace hada {
namespace {

constexpr double side = 400.0;
constexpr double middle = 0.5 * side;
constexpr double horizon = 178.0;  // radius of the rim
constexpr double quarter_turn = 0.5 * std::numbers::pi;

// Equal tilts at equal distances from the middle.
Eigen::Vector2d place(const Eigen::Vector3d& direction) {
  const double tilt = std::acos(std::clamp(direction.normalized().z(), -1.0, 1.0));
  const Eigen::Vector2d flat = direction.head<2>();
  const Eigen::Vector2d towards =
      flat.norm() > 1e-12 ? Eigen::Vector2d(flat.normalized()) : Eigen::Vector2d::Zero();
  const double radius = tilt / quarter_turn * horizon;
  return {middle + radius * towards.x(), middle - radius * towards.y()};
}

std::string rings_of_tilt() {
  std::string svg;
  for (const int tilt_deg : {30, 60, 90}) {
    const double radius = horizon * tilt_deg / 90.0;
    svg += fmt::format(
        "<circle cx=\"{0}\" cy=\"{0}\" r=\"{1:.1f}\" fill=\"none\" stroke=\"var(--line)\"/>"
        "<text x=\"{2:.1f}\" y=\"{3:.1f}\" class=\"soft\" font-size=\"10\">{4}\u00b0"
        "</text>",
        middle, radius, middle + 3.0, middle - radius + 11.0, tilt_deg);
  }
  return svg + fmt::format("<path d=\"M{0} {1} V{2} M{1} {0} H{2}\" stroke=\"var(--line)\"/>\n",
                           middle, middle - horizon, middle + horizon);
}

}  // namespace

std::string light_plot(const std::vector<LightSet>& sets, double magnified) {
  constexpr const char* colours[] = {"var(--data)", "var(--model)", "var(--third)"};
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", side, side + 20.0 * sets.size());
  svg += rings_of_tilt();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const char* colour = colours[std::min<std::size_t>(s, 2)];
    for (std::size_t i = 0; i < sets[s].lights.size(); ++i) {
      const Light& light = sets[s].lights[i];
      if (!std::isfinite(light.direction_sigma)) continue;
      const Eigen::Vector2d at = place(light.direction);
      const double blur = magnified * light.direction_sigma / quarter_turn * horizon;
      svg += fmt::format(
          "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\" fill=\"{3}\" opacity=\"0.22\"/>",
          at.x(), at.y(), std::min(blur, 60.0), colour);
      svg += s == 0 ? fmt::format(
                          "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"3.5\" fill=\"{2}\"/>"
                          "<text x=\"{3:.1f}\" y=\"{4:.1f}\">{5}</text>\n",
                          at.x(), at.y(), colour, at.x() + 7.0, at.y() - 5.0, i + 1)
                    : fmt::format(
                          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" "
                          "stroke=\"{}\" stroke-width=\"1.4\"/>\n",
                          at.x(), at.y(), 3.5 + 2.0 * double(s), colour);
    }
    svg += fmt::format(
        "<circle cx=\"10\" cy=\"{0}\" r=\"4\" fill=\"{1}\" stroke=\"{2}\"/>"
        "<text x=\"20\" y=\"{3}\">{4}</text>\n",
        side + 20.0 * double(s) + 6.0, s == 0 ? colour : "none", colour,
        side + 20.0 * double(s) + 10.0, escaped(sets[s].name));
  }
  return svg + "</svg>\n";
}

}  // namespace hada
