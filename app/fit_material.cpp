#include "app/fit_material.h"

#include "app/measurement.h"
#include "fit/wrinkle.h"

namespace hada {
namespace {

// One overload per material: the only place where its fit is called.
Fit<Wrinkle<>> fit_like(const Wrinkle<>&, const Surface& surface,
                        const FitMaterialOptions& options) {
  return fit_wrinkle(surface, {.components = options.components});
}

}  // namespace

MaterialFile fit_material(const std::string& name, Surface surface, const std::string& input_name,
                          const FitMaterialOptions& options) {
  MaterialFile file;
  const Material wanted = material_named(name);
  const bool has_height = surface.has_height();
  if (!has_height) surface.height = measured_map(surface);
  std::visit(
      [&](const auto& shape) {
        const auto fit = fit_like(shape, surface, options);
        file.material = fit.material;
        file.sigma = fit.sigma;
        file.goodness_p = fit.goodness_p;
        file.runner_up_gap = fit.runner_up_gap;
        file.on_bound = fit.on_bound;
        file.starts = fit.starts;
        file.agreeing = fit.agreeing;
        file.remarks = fit.remarks;
      },
      wanted);
  if (!has_height) {
    file.remarks.insert(file.remarks.begin(),
                        "The input has no height: its brightness (0 to 1) was fitted instead, so "
                        "amplitudes are brightness while lengths and angles keep their meaning.");
  }
  file.unit = surface.extent.unit;
  file.input = MaterialFile::Input{input_name, hash_of(surface.height), surface.extent};
  return file;
}

}  // namespace hada
