#include "fit/unit_map.h"

#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "core/mean.h"

namespace hada {
namespace {

double unit_of(std::string_view name, std::string_view unit, const MapUnits& units) {
  if (name == "amplitude_mm") return units.height;
  if (unit == "mm") return units.length;
  if (unit == "mm^4") return units.height * units.height * units.length * units.length;
  return 1.0;
}

void multiply(Grid<float>& values, double factor) {
  for (float& value : values) value = float(value * factor);
}

}  // namespace

MapUnits units_of(const Surface& surface) {
  MapUnits units{1.0, surface.extent.pitch};
  if (!surface.has_height()) return units;
  const double middle = mean(surface.height, surface.mask);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < surface.height.size(); ++i) {
    if (!surface.mask[i]) continue;
    sum += (surface.height[i] - middle) * (surface.height[i] - middle);
    count += 1.0;
  }
  if (sum > 0.0) units.height = std::sqrt(sum / count);
  return units;
}

Surface in_units(const Surface& surface, const MapUnits& units) {
  Surface map;
  map.extent = surface.extent;
  map.extent.pitch = surface.extent.pitch / units.length;
  map.mask = surface.mask;
  map.height = surface.height;
  multiply(map.height, 1.0 / units.height);
  if (!surface.has_height()) map.albedo = surface.albedo;
  map.normal_sigma = surface.normal_sigma;  // of slopes
  multiply(map.normal_sigma, units.length / units.height);
  map.levelling = surface.levelling;
  return map;
}

void give_back_units(Fit<Wrinkle<>>& fit, const MapUnits& units) {
  std::map<std::string, double> unit;  // by path
  const auto multiply_all = [&](Wrinkle<>& wrinkle) {
    visit_fields(wrinkle, [&](const std::string& path, const auto& field, double& value) {
      unit[path] = unit_of(field.name, field.unit, units);
      value *= unit[path];
    });
  };
  multiply_all(fit.sigma);
  multiply_all(fit.material);
  for (auto& interval : fit.intervals) {
    interval.low *= unit[interval.path];
    interval.high *= unit[interval.path];
  }
}

}  // namespace hada
