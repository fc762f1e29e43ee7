#include "app/report/compare_page.h"

#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "app/draw/maps.h"
#include "app/report/figure.h"
#include "app/report/html.h"
#include "app/report/sections.h"
#include "app/telling.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string maps(const Surface& first, const Surface& second, const Comparison& c) {
  std::vector<std::string> figures;
  const std::string unit(name_of(first.extent.unit));
  if (first.has_height()) {
    const ReliefStyle style = relief_style(second);
    figures.push_back(relief_figure(first, style, "The first surface."));
    figures.push_back(relief_figure(second, style, "The second, same scale and colours."));
  } else {
    figures.push_back(
        map_figure({albedo_picture(first), first.extent.width(), unit, {}, "The first picture."}));
    figures.push_back(map_figure(
        {albedo_picture(second), second.extent.width(), unit, {}, "The second picture."}));
  }
  if (c.overlap) {
    const Range range = range_of(c.overlap->difference, c.overlap->mask);
    figures.push_back(
        map_figure({scalar_picture(c.overlap->difference, c.overlap->mask, range),
                    c.overlap->cols * first.extent.pitch, unit,
                    ColourBar{range, c.first.quantity == "height" ? "difference (" + unit + ")"
                                                                  : std::string("difference")},
                    "First minus second, the best plane taken off."}));
  }
  return side_by_side(figures);
}

std::string ring_plot(const Comparison& c) {
  const std::string unit(name_of(c.first.extent.unit));
  std::vector<double> densities = c.first.rings.density;
  densities.insert(densities.end(), c.second.rings.density.begin(), c.second.rings.density.end());
  return plot(axis_over("frequency (cycles/" + unit + ")", true, c.first.rings.frequency),
              axis_over("power density", true, densities),
              {{.name = "first",
                .x = c.first.rings.frequency,
                .y = c.first.rings.density,
                .sigma = c.first.rings.sigma},
               {.name = "second",
                .colour = "var(--model)",
                .x = c.second.rings.frequency,
                .y = c.second.rings.density,
                .sigma = c.second.rings.sigma}});
}

std::string histogram_plot(const Histogram& first, const Histogram& second,
                           const std::string& label) {
  Series one{.name = "first"}, other{.name = "second", .colour = "var(--model)"};
  for (auto [series, source] : {std::pair{&one, &first}, std::pair{&other, &second}}) {
    for (std::size_t k = 0; k < source->density.size(); ++k) series->x.push_back(source->middle(k));
    series->y = source->density;
    series->sigma = source->sigma;
  }
  std::vector<double> places = one.x, densities = one.y;
  places.insert(places.end(), other.x.begin(), other.x.end());
  densities.insert(densities.end(), other.y.begin(), other.y.end());
  return plot(axis_over(label, false, places), axis_over("share per unit", false, densities),
              {one, other});
}

std::string plots(const Comparison& c) {
  const std::string unit(name_of(c.first.extent.unit));
  std::vector<std::string> figures{
      plot_figure(ring_plot(c), "How strong waves of each length are."),
      plot_figure(
          histogram_plot(c.first.values, c.second.values,
                         c.first.quantity == "height" ? "height (" + unit + ")" : c.first.quantity),
          "How often each " + c.first.quantity + " is met.")};
  if (c.first.slopes && c.second.slopes) {
    figures.push_back(plot_figure(histogram_plot(*c.first.slopes, *c.second.slopes, "slope"),
                                  "How often each slope is met."));
  }
  return side_by_side(figures);
}

std::string roughness_table(const Comparison& c) {
  std::vector<TableRow> rows;
  for (const RoughnessField& field : roughness_fields) {
    const auto of = [&](const Measurement& m) {
      return with_sigma(m.roughness.value.*(field.value), m.roughness.sigma.*(field.value));
    };
    rows.push_back({{std::string(field.name), of(c.first), of(c.second),
                     unit_of(field, c.first.extent.unit), std::string(field.meaning)}});
  }
  return table({"roughness", "first", "second", "unit", "meaning"}, rows);
}

}  // namespace

std::string compare_page(const Surface& first, const Surface& second, const Comparison& c) {
  std::string text = fmt::format(
      "The ring spectra differ by {:.2f} dB; two surfaces of one and the same kind would differ by "
      "{:.2f} dB.",
      c.spectral_distance_db, c.spectral_floor_db);
  if (c.overlap) {
    text += fmt::format(
        " Where both are known, on {} pixels, the first differs by {:.3g} root "
        "mean square, {:.2f} % of the spread of the second.",
        c.overlap->pixels, c.overlap->height_rmse,
        100.0 * c.overlap->height_rmse / c.overlap->height_std);
    if (c.overlap->has_normals) {
      text += fmt::format(" The normals differ by {:.3f} deg (mean), {:.3f} deg (median).",
                          c.overlap->normal_mean / degree, c.overlap->normal_median / degree);
    }
  } else {
    text += " They do not lie over each other, so only their statistics are compared.";
  }
  return page("Two surfaces compared", "<p class=\"lead\">" + escaped(text) + "</p>\n" +
                                           maps(first, second, c) + plots(c) + roughness_table(c));
}

}  // namespace hada
