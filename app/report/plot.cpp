#include "app/report/plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/report/html.h"

namespace hada {
namespace {

constexpr double width = 480.0;
constexpr double height = 300.0;
constexpr double left = 62.0;
constexpr double right = 12.0;
constexpr double top = 26.0;
constexpr double bottom = 44.0;

double share(const Axis& axis, double value) {
  if (!axis.log) return (value - axis.low) / (axis.high - axis.low);
  return std::log(value / axis.low) / std::log(axis.high / axis.low);
}

double x_of(const Axis& axis, double value) {
  return left + share(axis, value) * (width - left - right);
}

double y_of(const Axis& axis, double value) {
  return height - bottom - share(axis, value) * (height - top - bottom);
}

bool is_on(const Axis& axis, double value) {
  return std::isfinite(value) && (!axis.log || value > 0.0) && value >= axis.low &&
         value <= axis.high;
}

double onto(const Axis& axis, double value) {
  return std::clamp(value, axis.low, axis.high);
}

std::string frame(const Axis& x, const Axis& y) {
  std::string svg;
  for (const double tick : ticks(x)) {
    const double at = x_of(x, tick);
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"var(--line)\"/>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>\n",
        at, top, height - bottom, height - bottom + 16.0, tick_text(tick));
  }
  for (const double tick : ticks(y)) {
    const double at = y_of(y, tick);
    svg += fmt::format(
        "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" stroke=\"var(--line)\"/>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
        at, left, width - right, left - 6.0, at + 4.0, tick_text(tick));
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      0.5 * (left + width - right), height - 8.0, escaped(x.label), 0.5 * (top + height - bottom),
      escaped(y.label));
  return svg;
}

std::string line(const Axis& x, const Axis& y, const Series& series) {
  std::string points;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!is_on(x, series.x[i]) || !std::isfinite(series.y[i])) continue;
    if (y.log && series.y[i] <= 0.0) continue;
    points += fmt::format("{:.1f},{:.1f} ", x_of(x, series.x[i]), y_of(y, onto(y, series.y[i])));
  }
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
      "stroke-linejoin=\"round\"/>\n",
      points, series.colour);
}

std::string points(const Axis& x, const Axis& y, const Series& series) {
  std::string svg;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!is_on(x, series.x[i]) || !is_on(y, series.y[i])) continue;
    const double at = x_of(x, series.x[i]);
    if (i < series.sigma.size() && std::isfinite(series.sigma[i])) {
      svg += fmt::format(
          "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"{3}\"/>", at,
          y_of(y, onto(y, series.y[i] - series.sigma[i])),
          y_of(y, onto(y, series.y[i] + series.sigma[i])), series.colour);
    }
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.3\" fill=\"{}\"/>\n", at,
                       y_of(y, series.y[i]), series.colour);
  }
  return svg;
}

std::string legend(const std::vector<Series>& series) {
  std::string svg;
  double at = left;
  for (const auto& one : series) {
    svg += one.mark == Series::Mark::line
               ? fmt::format(
                     "<line x1=\"{}\" x2=\"{}\" y1=\"12\" y2=\"12\" stroke=\"{}\" "
                     "stroke-width=\"2\"/>",
                     at, at + 18.0, one.colour)
               : fmt::format("<circle cx=\"{}\" cy=\"12\" r=\"2.6\" fill=\"{}\"/>", at + 9.0,
                             one.colour);
    svg += fmt::format("<text x=\"{}\" y=\"16\">{}</text>\n", at + 23.0, escaped(one.name));
    at += 40.0 + 6.4 * double(one.name.size());
  }
  return svg;
}

}  // namespace

Axis axis_over(const std::string& label, bool log, const std::vector<double>& values) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value) || (log && value <= 0.0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return {label, log, log ? 0.1 : 0.0, 1.0};
  if (log) return {label, true, 0.7 * low, 1.4 * high};
  const double air = high > low ? 0.04 * (high - low) : 0.5;
  return {label, false, low - air, high + air};
}

std::vector<double> ticks(const Axis& axis, int wanted) {
  std::vector<double> found;
  const auto keep = [&](double tick) {
    if (is_on(axis, tick)) found.push_back(tick);
  };
  if (axis.log) {
    const double first = std::floor(std::log10(axis.low));
    const double last = std::ceil(std::log10(axis.high));
    const bool few = last - first <= 2.0;
    const double stride = std::max(1.0, std::ceil((last - first) / 7.0));
    for (double decade = first; decade <= last; decade += stride) {
      keep(std::pow(10.0, decade));
      if (!few) continue;
      keep(2.0 * std::pow(10.0, decade));
      keep(5.0 * std::pow(10.0, decade));
    }
    return found;
  }
  const double rough = (axis.high - axis.low) / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double multiple = rough / decade;
  const double step = decade * (multiple < 1.5 ? 1.0 : multiple < 3.5 ? 2.0 : 5.0);
  for (double k = std::ceil(axis.low / step); k * step <= axis.high; k += 1.0) keep(k * step);
  return found;
}

std::string tick_text(double value) {
  if (std::abs(value) < 1e-12) return "0";
  const double size = std::abs(value);
  if (size >= 1e-4 && size < 1e5) return fmt::format("{:.4g}", value);
  const int decade = int(std::floor(std::log10(size) + 1e-9));
  const double front = value / std::pow(10.0, decade);
  const std::string ten = fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>", decade);
  return std::abs(front - 1.0) < 1e-6 ? ten : fmt::format("{:.3g}\u00b7{}", front, ten);
}

std::string plot(const Axis& x, const Axis& y, const std::vector<Series>& series) {
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", width, height);
  svg += frame(x, y);
  for (const auto& one : series) {
    svg += one.mark == Series::Mark::line ? line(x, y, one) : points(x, y, one);
  }
  return svg + legend(series) + "</svg>\n";
}

}  // namespace hada
