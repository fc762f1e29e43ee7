#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "app/parameter_rows.h"
#include "app/part_order.h"
#include "app/report/figure.h"
#include "app/report/html.h"
#include "app/report/sections.h"
#include "app/telling.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle /= degree;
  return angles;
}

Axis density_axis(const std::vector<double>& measured, const std::string& unit) {
  return axis_over("power density (" + unit + "\u2074)", true, measured);
}

std::string ring_plot(const Measurement& m, const Rings& model, const std::string& unit) {
  std::vector<Series> series{{.name = "measured, with standard error",
                              .x = m.rings.frequency,
                              .y = m.rings.density,
                              .sigma = m.rings.sigma}};
  if (!model.density.empty()) {
    series.push_back({.name = "fitted material",
                      .mark = Series::Mark::line,
                      .colour = "var(--model)",
                      .x = model.frequency,
                      .y = model.density});
  }
  return plot(axis_over("frequency (cycles/" + unit + ")", true, m.rings.frequency),
              density_axis(m.rings.density, unit), series);
}

std::string sector_plot(const Measurement& m, const Sectors& model, const std::string& unit) {
  std::vector<Series> series{{.name = "measured, with standard error",
                              .x = in_degrees(m.sectors.angle),
                              .y = m.sectors.density,
                              .sigma = m.sectors.sigma}};
  if (!model.density.empty()) {
    series.push_back({.name = "fitted material",
                      .mark = Series::Mark::line,
                      .colour = "var(--model)",
                      .x = in_degrees(model.angle),
                      .y = model.density});
  }
  return plot({"direction of variation (deg from +x, counter-clockwise)", false, 0.0, 180.0},
              density_axis(m.sectors.density, unit), series);
}

std::map<std::string, double> by_path(const std::optional<Material>& material) {
  std::map<std::string, double> values;
  if (!material) return values;
  std::visit(
      [&](const auto& m) {
        visit_fields(
            m, [&](const std::string& path, const auto&, double value) { values[path] = value; });
      },
      *material);
  return values;
}

}  // namespace

std::string spectrum_section(const WholePath& path) {
  const Measurement& m = path.measurement;
  const std::string unit(name_of(m.extent.unit));
  const Spectrum expected = expected_spectrum(path.material.material, m.spectrum);
  const bool has_model = !expected.power.empty();
  const SpectrumStyle style = spectrum_style(m.spectrum);
  std::string text = fmt::format(
      "Roughness: Sa {:.3g} {u}, Sq {:.3g} {u}, skewness {:.2f}, kurtosis {:.2f}, slope {:.3g}; "
      "heights are alike over {:.3g} {u} (Sal), the texture runs at {:.0f} deg (Std) with an "
      "aspect of {:.2f} (Str).",
      m.roughness.value.Sa, m.roughness.value.Sq, m.roughness.value.Ssk, m.roughness.value.Sku,
      m.roughness.value.Sdq, m.roughness.value.Sal, m.roughness.value.Std / degree,
      m.roughness.value.Str, fmt::arg("u", unit));
  std::vector<std::string> spectra{
      spectrum_figure(spectrum_picture(m.spectrum, style), style, unit, "The measured spectrum.")};
  Rings model_rings;
  Sectors model_sectors;
  if (has_model) {
    model_rings = rings(expected, int(m.rings.density.size()));
    model_sectors = sectors(expected, int(m.sectors.density.size()));
    spectra.push_back(spectrum_figure(spectrum_picture(expected, style), style, unit,
                                      "The spectrum of the fitted material, same range."));
  }
  return "<h2>Its waves</h2>\n" + paragraph(escaped(text)) +
         side_by_side({plot_figure(ring_plot(m, model_rings, unit),
                                   "Rings: how strong waves of each length are."),
                       plot_figure(sector_plot(m, model_sectors, unit),
                                   "Sectors: how strong waves of each direction are.")}) +
         side_by_side(spectra);
}

std::string material_section(const WholePath& path) {
  const MaterialFile& file = path.material;
  std::vector<TableRow> rows;
  for (const ParameterRow& row : parameter_rows(file)) {
    rows.push_back({{escaped(row.name), row.number, row.unit, escaped(row.meaning)}});
  }
  std::string text = fmt::format("The best of {} starts; {} of them ended in the same place.",
                                 file.starts, file.agreeing);
  if (std::isfinite(file.goodness_p)) {
    text += fmt::format(
        " If the model were right, a misfit as large as this would be seen with a probability of "
        "{:.2g}.",
        file.goodness_p);
  }
  if (file.beyond_spectrum) {
    const auto& [gaussian, ridged] = *file.beyond_spectrum;
    text += fmt::format(
        " Beyond the spectrum: six moments of height, slope and curvature lie {:.1f} (chi-square) "
        "from those of a Gaussian sheet",
        gaussian.chi_square);
    text += ridged.chi_square < gaussian.chi_square
                ? fmt::format(
                      ", {:.1f} from those with the ridges that were found, which explain {:.0f} % "
                      "of it; the histograms of height, slope and curvature come from {:.3f}, "
                      "{:.3f}, {:.3f} to {:.3f}, {:.3f}, {:.3f} standard deviations.",
                      ridged.chi_square, 100.0 * (1.0 - ridged.chi_square / gaussian.chi_square),
                      gaussian.height, gaussian.slope, gaussian.curvature, ridged.height,
                      ridged.slope, ridged.curvature)
                : std::string("; 95 % of those lie within 12.6, and no ridges are needed.");
  }
  return "<h2>The material</h2>\n" + paragraph(escaped(text)) +
         table({escaped(name_of(file.material)), "value \u00b1 sigma", "unit", "meaning"}, rows);
}

std::string truth_section(const WholePath& path) {
  if (!path.truth) return "";
  const TruthCheck& truth = *path.truth;
  const auto order = part_order(path.material.material, truth.material);
  const int extra = part_count(path.material.material) - part_count(truth.material);
  std::string html = "<h2>Against the truth</h2>\n" +
                     paragraph("This capture was made by a virtual camera. Measured " +
                               escaped(told(truth)) + ".");
  if (extra < 0) {
    return html +
           paragraph(fmt::format("The fit found {} components, the truth has {}.",
                                 part_count(path.material.material), part_count(truth.material)));
  }
  const auto found = by_path(reordered(path.material.material, order));
  const auto sigma = by_path(
      path.material.sigma ? std::optional(reordered(*path.material.sigma, order)) : std::nullopt);
  std::vector<TableRow> rows;
  for (const auto& [name, value] : by_path(truth.material)) {
    const auto s = sigma.find(name);
    rows.push_back({{escaped(name), fmt::format("{:.4g}", value),
                     with_sigma(found.at(name), s == sigma.end() ? 0.0 : s->second), ""}});
  }
  if (extra > 0) {
    html += paragraph(fmt::format("{} further component{} explain{} what the measurement adds.",
                                  extra, extra == 1 ? "" : "s", extra == 1 ? "s" : ""));
  }
  return html + table({"parameter", "truth", "found \u00b1 sigma", ""}, rows);
}

std::string advice_section(const WholePath& path) {
  std::vector<std::string> remarks;
  for (const auto* list :
       {&path.lit.remarks, &path.reconstruction.remarks, &path.material.remarks}) {
    remarks.insert(remarks.end(), list->begin(), list->end());
  }
  if (std::isfinite(path.material.goodness_p) && path.material.goodness_p < 0.01) {
    remarks.push_back(
        "The material does not explain the surface fully (see the probability above): look where "
        "the points leave the line, and try another number of components or another material.");
  }
  std::string html = "<h2>If it is not good enough</h2>\n";
  html += remarks.empty() ? paragraph("Nothing in this measurement calls for attention.")
                          : bullets(remarks);
  return html + paragraph(
                    "What helps most, in this order: lights from more sides and at 30 to 60 "
                    "degrees of tilt; a larger and rounder sphere, sharp and not clipped; 16-bit "
                    "linear pictures; more pixels to the shortest wave that matters; a larger "
                    "piece of the sample for the longest.");
}

}  // namespace hada
