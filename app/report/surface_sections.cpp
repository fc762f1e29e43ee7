#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/report/figure.h"
#include "app/report/html.h"
#include "app/report/sections.h"
#include "app/telling.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

MapFigure map_of(const Surface& surface, Image picture, const std::string& caption) {
  return {std::move(picture),
          surface.extent.width(),
          std::string(name_of(surface.extent.unit)),
          {},
          caption};
}

std::string sigma_figure(const Surface& surface, const Grid<float>& sigma, double scale,
                         const std::string& label, const std::string& caption) {
  Range range = range_of(sigma, surface.mask, 0.01);
  range.low = 0.0;
  MapFigure figure = map_of(surface, scalar_picture(sigma, surface.mask, range), caption);
  figure.colours = ColourBar{{0.0, scale * range.high}, label};
  return map_figure(figure);
}

double covered(const Mask& mask) {
  double count = 0.0;
  for (const auto inside : mask) count += inside ? 1.0 : 0.0;
  return mask.empty() ? 0.0 : count / double(mask.size());
}

}  // namespace

std::string relief_figure(const Surface& surface, const ReliefStyle& style,
                          const std::string& caption) {
  MapFigure figure = map_of(surface, relief_picture(surface, style), caption);
  figure.colours =
      ColourBar{style.height, "height (" + std::string(name_of(surface.extent.unit)) + ")"};
  return map_figure(figure);
}

std::string surface_section(const WholePath& path) {
  const Reconstruction& r = path.reconstruction;
  const Surface& s = r.surface;
  const std::string unit(name_of(s.extent.unit));
  const ReliefStyle style = relief_style(s);
  std::string text = fmt::format(
      "The sample covers {:.0f} % of a box of {:.4g} x {:.4g} {}. The {} was taken off the height. "
      "One grey sample is uncertain by {:.2g} % of the largest value; pictures predicted from the "
      "surface differ from those taken by {:.1f} %.",
      100.0 * covered(s.mask), s.extent.width(), s.extent.height(), unit, s.levelling,
      100.0 * r.noise, 100.0 * r.relighting_error);
  std::vector<std::string> maps;
  maps.push_back(relief_figure(
      s, style,
      fmt::format("Height, lit from the upper left, slopes drawn {:.2g} times as steep.",
                  style.exaggeration)));
  maps.push_back(map_figure(
      map_of(s, normal_picture(s), "Normals: red to the right, green up, blue to the camera.")));
  if (!s.albedo.empty()) {
    maps.push_back(map_figure(
        map_of(s, albedo_picture(s), "Albedo: what is left when the shading is taken away.")));
  }
  if (!s.normal_sigma.empty()) {
    maps.push_back(sigma_figure(s, s.normal_sigma, 1.0 / degree, "sigma of the normal (deg)",
                                "How sure the normals are."));
  }
  if (!s.height_sigma.empty()) {
    maps.push_back(sigma_figure(s, s.height_sigma, 1.0, "sigma of the height (" + unit + ")",
                                "How sure the height is; errors of the normals add up over "
                                "distance."));
  }
  return "<h2>The surface</h2>\n" + paragraph(escaped(text)) + side_by_side(maps);
}

std::string synthesis_section(const WholePath& path) {
  const Surface& measured = path.reconstruction.surface;
  const ReliefStyle style = relief_style(measured);
  return "<h2>More of it</h2>\n" +
         paragraph(escaped(fmt::format(
             "A new piece of the same material, from seed {}. It is not a copy: only the "
             "statistics agree. Both are drawn at the same scale, with the same colours and the "
             "same light.",
             path.material.seed.value_or(0)))) +
         side_by_side({relief_figure(measured, style, "Measured."),
                       relief_figure(path.synthesized, style, "Made from the fitted material.")});
}

}  // namespace hada
