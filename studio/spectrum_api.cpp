#include "studio/spectrum_api.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/spectrum_picture.h"
#include "app/material_file.h"
#include "app/parameter_rows.h"
#include "app/report/html.h"
#include "app/telling.h"
#include "core/error.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "studio/folder.h"

namespace hada {
namespace {

constexpr int side_px = 640;  // of the picture of a spectrum

// Where the power density of a noise function has fallen to half: half axes in cycles per unit,
// the first along `angle_rad`. From its `psd`: 4 pi^2 (l^2 fl^2 + s^2 fs^2) = ln 2.
Json ellipse(const WrinkleComponent<>& component, double long_more, double short_more) {
  const auto half_power = [](double size) {
    return std::sqrt(std::numbers::ln2) / (2.0 * std::numbers::pi * size);
  };
  return {half_power(component.long_mm + long_more), half_power(component.short_mm + short_more)};
}

// One for each plain noise function, with the ellipses one sigma larger and smaller.
Json ellipses(const MaterialFile& file) {
  Json list = Json::array();
  const auto* wrinkle = std::get_if<Wrinkle<>>(&file.material);
  const auto* sigma = file.sigma ? std::get_if<Wrinkle<>>(&*file.sigma) : nullptr;
  for (std::size_t k = 0; wrinkle && k < wrinkle->components.size(); ++k) {
    const WrinkleComponent<>& component = wrinkle->components[k];
    Json one = {{"angle_rad", component.angle_rad}, {"axes", ellipse(component, 0.0, 0.0)}};
    if (sigma && k < sigma->components.size()) {
      const double l = std::min(sigma->components[k].long_mm, 0.9 * component.long_mm);
      const double s = std::min(sigma->components[k].short_mm, 0.9 * component.short_mm);
      one["between"] = {ellipse(component, l, s), ellipse(component, -l, -s)};
    }
    list.push_back(one);
  }
  return list;
}

Json parameters(const MaterialFile& file) {
  Json rows = Json::array();
  for (const ParameterRow& row : parameter_rows(file)) {
    rows.push_back(
        {{"name", row.name}, {"number", row.number}, {"unit", row.unit}, {"meaning", row.meaning}});
  }
  return rows;
}

Json measurement_json(const Measurement& m) {
  const SpectrumStyle style = spectrum_style(m.spectrum);
  return {{"measure", Json::parse(measurement_text(m))},
          {"highest_frequency", style.highest_frequency},
          {"log_power", {style.log_power.low, style.log_power.high}},
          {"picture", data_address(spectrum_picture(m.spectrum, style, side_px))}};
}

// What `m` would be expected to be, were its surface made of this.
Json model_json(const Measurement& m, const MaterialFile& file) {
  Json json = {
      {"told", told(file)},         {"remarks", file.remarks}, {"parameters", parameters(file)},
      {"ellipses", ellipses(file)}, {"rings", nullptr},        {"sectors", nullptr},
      {"picture", nullptr}};
  const Spectrum expected = expected_spectrum(file.material, m.spectrum);
  if (expected.power.empty()) return json;
  json["rings"] = rings(expected, int(m.rings.density.size())).density;
  json["sectors"] = sectors(expected, int(m.sectors.density.size())).density;
  json["picture"] = data_address(spectrum_picture(expected, spectrum_style(m.spectrum), side_px));
  return json;
}

}  // namespace

const Measurement& SpectrumApi::measured(const std::string& name) {
  const auto place = place_within(folder_, name);
  if (!measured_ || name_ != name) {
    measured_.reset();
    try {
      measured_ = measure(read_surface(place));
    } catch (const Error& error) {
      throw Error(without_folder(folder_, error.what()));
    }
    name_ = name;
  }
  return *measured_;
}

HttpResponse SpectrumApi::answer(const std::string& verb, const HttpRequest& request) {
  if (request.method == "POST" && (verb == "measure" || verb == "model")) {
    const Json json = parsed_json(request.body, "the request");
    JsonObject object(json, "the request");
    const std::string name = object.text("name");
    if (verb == "model") object.object("file");
    object.finish();
    const std::lock_guard lock(busy_);
    if (verb == "measure") {
      measured_.reset();  // the surface may be another one by now
      return {.body = measurement_json(measured(name)).dump()};
    }
    const MaterialFile file = material_of(json["file"].dump(), "the material");
    return {.body = model_json(measured(name), file).dump()};
  }
  throw Error("spectrum/" + verb + ": there is no such request");
}

}  // namespace hada
