#include "app/fit_material.h"

#include <algorithm>

#include "app/knit_files.h"
#include "app/measurement.h"
#include "core/mean.h"
#include "core/srgb.h"
#include "fit/knit.h"
#include "fit/wood.h"
#include "fit/wrinkle.h"
#include "measure/measured_map.h"

namespace hada {
namespace {

// One overload per material: the only place where its fit is called.
WrinkleFit fit_like(const Wrinkle<>&, const Surface& surface, const FitMaterialOptions& options) {
  return fit_wrinkle(surface, {.components = options.components,
                               .lens_blur_px = options.lens_blur_px,
                               .ridges = options.ridges,
                               .progress = options.progress});
}

// What the knit at rest does not show, from photographs of it pulled.
void add_pulled(Fit<Knit<>>& fit, const Surface& rest, PulledKnitInput& pulled) {
  pulled.found = fit_photographs(rest, fit.material, repeat_of(fit.material), pulled.photographs,
                                 pulled.piece);
  const KnitStiffness& stiffness = pulled.found.stiffness;
  fit.material.stiffness_ratio = stiffness.ratio.value;
  fit.material.yarn_coefficient = stiffness.continuity.value;
  fit.sigma.stiffness_ratio = stiffness.ratio.sigma;
  fit.sigma.yarn_coefficient = stiffness.continuity.sigma;
  std::erase(fit.remarks, knit_at_rest_remark);
  for (const auto& remark : pulled.found.remarks) fit.remarks.push_back(remark);
  for (const auto& remark : stiffness.remarks) fit.remarks.push_back(remark);
}

Fit<Knit<>> fit_like(const Knit<>&, const Surface& surface, const FitMaterialOptions& options) {
  auto fit = fit_knit(surface, {.courses = options.components});
  if (options.pulled) add_pulled(fit, surface, *options.pulled);
  return fit;
}

Fit<Wood<>> fit_like(const Wood<>&, const Surface& surface, const FitMaterialOptions& options) {
  const WoodView view = options.view == "face"        ? WoodView::face
                        : options.view == "end-grain" ? WoodView::end_grain
                                                      : WoodView::automatic;
  return fit_wood(surface, {.view = view, .face = options.face});
}

ForgedFit fit_like(const Forged<>&, const Surface& surface, const FitMaterialOptions& options) {
  auto fit = fit_forged(
      surface, {.view = options.view == "block" ? GrainView::block : GrainView::automatic});
  if (options.forged) *options.forged = fit;
  return fit;
}

// What only some fits have to tell.
template <class M>
void add_findings(MaterialFile&, const Fit<M>&) {}

void add_findings(MaterialFile& file, const WrinkleFit& fit) {
  const auto side = [](double chi_square, const RidgeEvidence::Histograms& apart) {
    return MaterialFile::BeyondSpectrum::Side{chi_square, apart.height, apart.slope,
                                              apart.curvature};
  };
  if (!(fit.ridges.departure > 0.0)) return;
  file.beyond_spectrum = {side(fit.ridges.departure, fit.ridges.gaussian),
                          side(fit.ridges.left, fit.ridges.ridged)};
}

void add_findings(MaterialFile& file, const ForgedFit& fit) {
  for (const auto& one : fit.posterior) file.choices.push_back({one.sequences, one.probability});
  file.kinds = {
      {"masame", fit.kinds.masame}, {"itame", fit.kinds.itame}, {"mokume", fit.kinds.mokume}};
}

// Of the hue that the picture has on the whole: linear, as many values as it has planes; none where
// it is as dark as what was taken off it.
std::vector<double> colour_of_mean_brightness(const Surface& picture) {
  std::vector<double> colour;
  for (const auto& plane : picture.albedo.planes) {
    colour.push_back(std::max(0.0, mean(plane, picture.mask)));
  }
  const double luminance_of_means = mean(luminance(picture.albedo), picture.mask);
  const double wanted = linear_from_srgb(float(mean(measured_map(picture), picture.mask)));
  if (!(luminance_of_means > 0.0 && wanted > 0.0)) return {};
  for (double& value : colour) value *= wanted / luminance_of_means;
  return colour;
}

}  // namespace

MaterialFile fit_material(const std::string& name, const Surface& surface,
                          const std::string& input_name, const FitMaterialOptions& options) {
  MaterialFile file;
  std::visit(
      [&](const auto& shape) {
        const auto fit = fit_like(shape, surface, options);
        file.material = fit.material;
        file.sigma = fit.sigma;
        file.goodness_p = fit.goodness_p;
        file.runner_up_gap = fit.runner_up_gap;
        file.on_bound = fit.on_bound;
        file.intervals = fit.intervals;
        file.starts = fit.starts;
        file.agreeing = fit.agreeing;
        file.remarks = fit.remarks;
        add_findings(file, fit);
      },
      material_named(name));
  file.unit = surface.extent.unit;
  if (!surface.has_height() && std::holds_alternative<Wrinkle<>>(file.material)) {
    file.mean_albedo = colour_of_mean_brightness(surface);
  }
  file.input = MaterialFile::Input{input_name, hash_of(measured_map(surface)), surface.extent};
  return file;
}

}  // namespace hada
