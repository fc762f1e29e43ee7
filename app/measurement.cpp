#include "app/measurement.h"

#include <cmath>

#include "core/mean.h"
#include "core/parallel.h"
#include "io/json.h"
#include "measure/measured_map.h"

namespace hada {
namespace {

// JSON has no word for what is not known.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Roughness& roughness) {
  Json json;
  for (const RoughnessField& field : roughness_fields) {
    const double value = roughness.*(field.value);
    json[std::string(field.name) + (field.unit == "rad" ? "_rad" : "")] = number(value);
  }
  return json;
}

Json numbers(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(number(value));
  return json;
}

// What rings and sectors have in common.
template <class Summary>
Json json_of(const Summary& summary, const char* place, const std::vector<double>& places) {
  return {
      {place, places},          {"power", summary.power},        {"density", summary.density},
      {"sigma", summary.sigma}, {"low95", numbers(summary.low)}, {"high95", numbers(summary.high)},
      {"count", summary.count}};
}

Json json_of(const Decay& decay) {
  const auto hurst = decay.hurst();
  return {{"plateau", decay.plateau},
          {"plateau_sigma", decay.plateau_sigma},
          {"corner", decay.corner},
          {"corner_sigma", decay.corner_sigma},
          {"slope", decay.slope},
          {"slope_sigma", decay.slope_sigma},
          {"hurst", hurst ? Json(*hurst) : Json()},
          {"floor", decay.floor},
          {"floor_sigma", decay.floor_sigma},
          {"misfit", decay.misfit}};
}

Json json_of(const Histogram& histogram) {
  return {{"low", histogram.low},
          {"step", histogram.step},
          {"density", histogram.density},
          {"sigma", histogram.sigma}};
}

Json json_of(const std::vector<Band>& bands) {
  Json json = Json::array();
  for (const Band& band : bands) {
    json.push_back({{"wavelength", band.wavelength},
                    {"wavelength_sigma", band.wavelength_sigma},
                    {"direction_rad", band.direction},
                    {"direction_sigma_rad", band.direction_sigma},
                    {"rms", band.rms},
                    {"rms_sigma", band.rms_sigma},
                    {"anisotropy", band.anisotropy}});
  }
  return json;
}

Json peaks_json(const Measurement& m) {
  Json of_rings = Json::array();
  for (const int i : m.ring_peaks) {
    of_rings.push_back({{"frequency", m.rings.frequency[std::size_t(i)]},
                        {"power", m.rings.power[std::size_t(i)]}});
  }
  Json of_sectors = Json::array();
  for (const int i : m.sector_peaks) {
    of_sectors.push_back({{"angle_rad", m.sectors.angle[std::size_t(i)]},
                          {"power", m.sectors.power[std::size_t(i)]}});
  }
  return {{"rings", of_rings}, {"sectors", of_sectors}};
}

}  // namespace

std::string unit_of(const RoughnessField& field, Unit unit) {
  std::string text(field.unit);
  if (const auto at = text.find("unit"); at != std::string::npos) {
    text.replace(at, 4, name_of(unit));
  }
  return text;
}

Measurement measure(const Surface& surface) {
  constexpr int most_peaks = 4;
  constexpr double spreads = 4.0;  // that a histogram reaches
  const Grid<float> map = measured_map(surface);
  Measurement m;
  m.quantity = surface.has_height() ? "height" : "brightness";
  m.extent = surface.extent;
  m.roughness = roughness_estimate(map, surface.mask, surface.extent.pitch);
  m.spectrum = power_spectrum(map, surface.mask, surface.extent);
  m.rings = rings(m.spectrum);
  m.sectors = sectors(m.spectrum);
  m.decay = decay_of(m.rings);
  m.bands = bands(m.spectrum, map, surface.mask);
  const Roughness& rough = m.roughness.value;
  const double middle = mean(map, surface.mask);
  m.values = histogram(map, surface.mask, middle - spreads * rough.Sq, middle + spreads * rough.Sq);
  if (surface.has_height()) {
    m.slopes = histogram(steepness(map, surface.mask, surface.extent.pitch), surface.mask, 0.0,
                         spreads * rough.Sdq);
  }
  m.ring_peaks = peaks(m.rings.power, most_peaks, false);
  m.sector_peaks = peaks(m.sectors.power, most_peaks, true);
  return m;
}

std::string measurement_text(const Measurement& m) {
  const Json json = {{"hada", "measure/1"},
                     {"quantity", m.quantity},
                     {"unit", name_of(m.extent.unit)},
                     {"pitch", m.extent.pitch},
                     {"size_px", {m.extent.cols, m.extent.rows}},
                     {"roughness", json_of(m.roughness.value)},
                     {"roughness_sigma", json_of(m.roughness.sigma)},
                     {"rings", json_of(m.rings, "frequency", m.rings.frequency)},
                     {"sectors", json_of(m.sectors, "angle_rad", m.sectors.angle)},
                     {"decay", m.decay ? json_of(*m.decay) : Json()},
                     {"bands", json_of(m.bands)},
                     {"histogram", json_of(m.values)},
                     {"slope_histogram", m.slopes ? json_of(*m.slopes) : Json()},
                     {"peaks", peaks_json(m)}};
  return json.dump(1) + "\n";
}

std::string roughness_text(const Roughness& roughness) {
  return json_of(roughness).dump();
}

Spectrum expected_spectrum(const Material& material, const Spectrum& like) {
  Spectrum expected = like;
  expected.power = {};
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { psd(m, 0.0, 0.0); }) {
          expected.power = Grid<double>(like.power.rows(), like.power.cols());
          for_each_index(expected.power.rows(), [&](int row) {
            for (int col = 0; col < expected.power.cols(); ++col) {
              expected.power(row, col) =
                  psd(m, like.fx(col), like.fy(row), {like.window_x, 0.0, like.window_y});
            }
          });
        }
      },
      material);
  return expected;
}

}  // namespace hada
