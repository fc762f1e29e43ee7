#include "app/report/figure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/draw/palette.h"
#include "app/report/html.h"

namespace hada {
namespace {

constexpr double width = 480.0;  // of every figure, in the units of its SVG

std::string captioned(const std::string& svg, const std::string& caption) {
  return "<figure>" + svg + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string picture_at(const Image& picture, double x, double y, double w, double h) {
  return fmt::format(
      "<image x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
      "preserveAspectRatio=\"none\" href=\"{4}\"/>"
      "<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" fill=\"none\" "
      "stroke=\"var(--line)\"/>\n",
      x, y, w, h, data_address(picture));
}

// The longest of 1, 2, 5 times a power of ten that is at most a third of the picture.
double scale_length(double picture_width) {
  const double most = picture_width / 3.0;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double multiple : {5.0, 2.0}) {
    if (multiple * decade <= most) return multiple * decade;
  }
  return decade;
}

std::string scale_bar(const MapFigure& figure, double y) {
  const double length = scale_length(figure.width);
  const double drawn = length / figure.width * width;
  return fmt::format(
      "<path d=\"M0.5 {0:.1f} v8 M0.5 {1:.1f} h{2:.1f} m0 -4 v8\" stroke=\"currentColor\" "
      "fill=\"none\" stroke-width=\"1.5\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\">{5} {6}</text>\n",
      y, y + 4.0, drawn, drawn + 7.0, y + 8.5, tick_text(length), figure.unit);
}

std::string colour_bar(const ColourBar& bar, double y) {
  constexpr double from = 220.0;
  constexpr double to = width - 14.0;
  constexpr int steps = 32;
  std::string svg;
  for (int i = 0; i < steps; ++i) {
    // Each rectangle overlaps the next by a little: no hairlines between them.
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"8\" fill=\"{}\"/>",
        from + i * (to - from) / steps, y, (to - from) / steps + (i + 1 < steps ? 0.6 : 0.0),
        css(sequential((i + 0.5) / steps)));
  }
  const Axis axis{"", false, bar.range.low, bar.range.high};
  for (const double tick : ticks(axis, 4)) {
    const double x = from + (tick - axis.low) / (axis.high - axis.low) * (to - from);
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" "
        "stroke=\"currentColor\"/><text x=\"{0:.1f}\" y=\"{3:.1f}\" "
        "text-anchor=\"middle\">{4}</text>",
        x, y + 8.0, y + 11.0, y + 23.0, tick_text(tick));
  }
  return svg + fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", to,
                           y + 38.0, escaped(bar.label));
}

}  // namespace

std::string map_figure(const MapFigure& figure) {
  constexpr int most_px = 720;
  const double tall = width * figure.picture.rows() / std::max(1, figure.picture.cols());
  const double foot = figure.colours ? 50.0 : 22.0;
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {} {:.1f}\" role=\"img\">\n", width, tall + foot);
  svg += picture_at(shrunk(figure.picture, most_px), 0.0, 0.0, width, tall);
  svg += scale_bar(figure, tall + 8.0);
  if (figure.colours) svg += colour_bar(*figure.colours, tall + 8.0);
  return captioned(svg + "</svg>", figure.caption);
}

std::string spectrum_figure(const Image& picture, const SpectrumStyle& style,
                            const std::string& unit, const std::string& caption,
                            const std::string& power_unit) {
  constexpr double left = 58.0;
  constexpr double side = width - left - 12.0;
  const double reach = style.highest_frequency;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", width, side + 92.0);
  svg += picture_at(picture, left, 4.0, side, side);
  const Axis axis{"", false, -reach, reach};
  for (const double tick : ticks(axis)) {
    const double along = 0.5 * (tick / reach + 1.0) * side;
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
        left + along, side + 20.0, tick_text(tick), left - 6.0, 4.0 + side - along + 4.0,
        tick_text(tick));
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">fx (cycles/{})</text>"
      "<text transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">fy "
      "(cycles/{})</text>\n",
      left + 0.5 * side, side + 38.0, unit, 4.0 + 0.5 * side, unit);
  const std::string density = power_unit.empty() ? unit + "\u2074" : power_unit;
  svg += colour_bar({style.log_power, "log10 of the power density (" + density + ")"}, side + 48.0);
  return captioned(svg + "</svg>", caption);
}

std::string photograph_figure(const PhotographFigure& figure) {
  const double cols = figure.picture.cols() * figure.pixel;
  const double rows = figure.picture.rows() * figure.pixel;
  const double hair = cols / 160.0;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {:.1f} {:.1f}\" role=\"img\">\n", cols, rows);
  svg += picture_at(figure.picture, 0.0, 0.0, cols, rows);
  for (const auto& sphere : figure.spheres) {
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" stroke=\"#ff8c1a\" "
        "stroke-width=\"{:.2f}\"/>",
        sphere.center_px.x(), sphere.center_px.y(), sphere.radius_px, hair);
  }
  for (const auto& at : figure.highlights_px) {
    if (!at.allFinite()) continue;
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f} h{:.1f} M{:.1f} {:.1f} v{:.1f}\" stroke=\"#22d3ee\" "
        "stroke-width=\"{:.2f}\"/>",
        at.x() - 3.0 * hair, at.y(), 6.0 * hair, at.x(), at.y() - 3.0 * hair, 6.0 * hair, hair);
  }
  return captioned(svg + "</svg>", figure.caption);
}

std::string plot_figure(const std::string& svg, const std::string& caption) {
  return captioned(svg, caption);
}

}  // namespace hada
