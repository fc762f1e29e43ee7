#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/report/figure.h"
#include "app/report/html.h"
#include "app/report/light_plot.h"
#include "app/report/sections.h"
#include "app/telling.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string sphere_sentence(const SphereReading& reading) {
  const Sphere& s = reading.sphere;
  std::string text =
      fmt::format("A {} sphere lies at ({:.1f}, {:.1f}) px, radius {} px", name_of(s.kind),
                  s.center_px.x(), s.center_px.y(), with_sigma(s.radius_px, s.sigma_px));
  if (s.kind == SphereKind::matte) {
    text += fmt::format("; its shading is explained but for {:.2g} %", 100.0 * reading.misfit);
  }
  return text + ".";
}

std::vector<Eigen::Vector2d> highlights_in(const LitCapture& lit, std::size_t picture) {
  std::vector<Eigen::Vector2d> found;
  if (!lit.calibration) return found;
  for (const auto& reading : lit.calibration->readings) {
    if (picture < reading.highlights_px.size()) found.push_back(reading.highlights_px[picture]);
  }
  return found;
}

std::string angle_text(double sigma) {
  return std::isfinite(sigma) && sigma > 0.0 ? fmt::format("{:.2g}", sigma / degree)
                                             : std::string("given");
}

std::string light_table(const std::vector<Light>& lights) {
  std::vector<TableRow> rows;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    const double tilt = std::acos(std::clamp(light.direction.z(), -1.0, 1.0));
    const double azimuth = std::atan2(light.direction.y(), light.direction.x());
    rows.push_back({{std::to_string(i + 1), fmt::format("{:.2f}", tilt / degree),
                     fmt::format("{:.2f}", azimuth / degree), angle_text(light.direction_sigma),
                     fmt::format("{:.3f}", light.strength.mean()), escaped(light.image)}});
  }
  return table({"light", "tilt (deg)", "azimuth (deg)", "sigma (deg)", "strength", "picture"},
               rows);
}

}  // namespace

std::string pictures_section(const WholePath& path) {
  const Photographs& photographs = path.lit.photographs;
  constexpr std::size_t most = 12;
  const std::vector<Image>& images = path.lit.stack.images;
  const std::size_t shown = std::min(most, images.size());
  std::string html = "<h2>The pictures</h2>\n";
  std::string text = fmt::format("{} pictures, {} bit, read as {} values.", images.size(),
                                 photographs.bits, photographs.linear ? "linear" : "sRGB");
  if (shown < images.size()) text += fmt::format(" The first {} are shown.", shown);
  if (path.lit.calibration) {
    for (const auto& reading : path.lit.calibration->readings) {
      text += " " + sphere_sentence(reading);
    }
  }
  if (!path.lit.spheres.empty()) {
    text += " Circles show the spheres as they were found, crosses where each light is seen.";
  }
  html += paragraph(escaped(text)) + "<div class=\"strip\">\n";
  for (std::size_t k = 0; k < shown; ++k) {
    const Image small = thumbnail(images[k], true, 300);
    images[k].let_go();
    html += photograph_figure({small, double(images[k].cols()) / std::max(1, small.cols()),
                               path.lit.spheres, highlights_in(path.lit, k),
                               fmt::format("{}: {}", k + 1, photographs.file.pictures[k].name)});
  }
  return html + "</div>\n";
}

std::string lights_section(const WholePath& path) {
  const auto& lights = path.lit.lights.lights;
  constexpr double magnified = 10.0;
  std::vector<LightSet> sets{{"in force", lights}};
  if (path.lit.calibration && path.lit.calibration->readings.size() > 1) {
    for (const auto& reading : path.lit.calibration->readings) {
      sets.push_back(
          {"by the " + std::string(name_of(reading.sphere.kind)) + " sphere", reading.lights});
    }
  }
  std::string text = "The lights come from " + path.lit.source + ".";
  const double sigma = direction_sigma_deg(lights);
  if (sigma > 0.0) {
    text += fmt::format(" A direction is known to {:.2g} deg in each of two directions.", sigma);
  }
  if (sets.size() > 2) {
    text += fmt::format(" The spheres, each by itself, disagree by {:.2f} deg on average.",
                        path.lit.calibration->disagreement / degree);
  }
  return "<h2>The lights</h2>\n" + paragraph(escaped(text)) +
         side_by_side(
             {plot_figure(light_plot(sets, magnified),
                          fmt::format("Where the lights stand, seen from above: straight overhead "
                                      "in the middle, the horizon at the rim. Discs: standard "
                                      "deviation, drawn {:.0f} times as large.",
                                      magnified)),
              light_table(lights)});
}

}  // namespace hada
