#include "app/lit_capture.h"

#include "capture/diagnose.h"
#include "capture/encoding.h"
#include "capture/find_spheres.h"
#include "capture/given_lights.h"
#include "capture/light_stack.h"
#include "capture/movement.h"
#include "capture/strengths.h"

namespace hada {
namespace {

void add(std::vector<std::string>& remarks, const std::vector<std::string>& more) {
  remarks.insert(remarks.end(), more.begin(), more.end());
}

// Spheres lie beside the sample and must not be taken for it; an owner's mask already says so.
std::vector<Sphere> spheres_beside(const Photographs& photographs, const Terminal& terminal) {
  if (!photographs.mask.empty()) return {};
  terminal.step("looking for spheres beside the sample");
  return find_spheres(photographs).spheres;
}

void believe(Photographs& photographs, bool linear) {
  photographs.linear = linear;
  photographs.encoding_known = true;
}

// Error modes are vectors as long as the light is strong: they grow and shrink with it.
std::vector<LightErrorMode> rescaled(std::vector<LightErrorMode> modes,
                                     const std::vector<Light>& before,
                                     const std::vector<Light>& after) {
  for (LightErrorMode& mode : modes) {
    for (std::size_t k = 0; k < mode.size(); ++k) {
      mode[k] *= after[k].strength.mean() / before[k].strength.mean();
    }
  }
  return modes;
}

}  // namespace

Photographs load_folder(const std::filesystem::path& folder, const Terminal& terminal,
                        std::optional<double> pitch_mm) {
  CaptureFile file = read_capture_file(folder);
  if (pitch_mm) file.pitch_mm = pitch_mm;
  terminal.step("loading " + std::to_string(file.pictures.size()) + " pictures");
  return load_photographs(file);
}

LightsFile lights_file(const Calibration& calibration, Unit unit) {
  LightsFile file;
  file.lights = calibration.lights;
  file.errors = calibration.errors;
  file.position_unit = unit;
  file.strengths_measured = calibration.strengths_measured;
  if (calibration.encoding_known) file.encoding = calibration.linear ? "linear" : "srgb";
  file.highlights_px.resize(file.lights.size());
  for (const auto& reading : calibration.readings) {
    file.spheres.push_back(reading.sphere);
    for (std::size_t k = 0; k < std::min(reading.highlights_px.size(), file.lights.size()); ++k)
      file.highlights_px[k].push_back(reading.highlights_px[k]);
  }
  return file;
}

LitCapture lit_capture(Photographs photographs,
                       const std::optional<std::filesystem::path>& lights_path,
                       const Terminal& terminal) {
  LitCapture lit;
  if (lights_path) {
    lit.lights = matched_lights(read_lights(*lights_path), photographs);
    lit.spheres = spheres_beside(photographs, terminal);
    lit.source = lights_path->filename().string();
    if (!photographs.encoding_known && !lit.lights.encoding.empty()) {
      believe(photographs, lit.lights.encoding == "linear");
    }
  } else if (auto given = lights_in(photographs.file); !given.empty()) {
    lit.lights.lights = std::move(given);
    lit.spheres = spheres_beside(photographs, terminal);
    lit.source = "the manifest";
  } else {
    terminal.step("reading the lights off the spheres");
    lit.calibration = calibrate(photographs);
    lit.lights = lights_file(*lit.calibration, photographs.camera.extent.unit);
    lit.spheres = lit.lights.spheres;
    lit.source = "the spheres in the pictures";
    photographs.ambient_light = lit.calibration->ambient_light;
    if (lit.calibration->encoding_known) believe(photographs, lit.calibration->linear);
    add(lit.remarks, lit.calibration->remarks);
  }
  settle_encoding(photographs, lit.lights.lights);
  lit.lights.encoding = photographs.linear ? "linear" : "srgb";
  if (!lit.calibration) {
    add(lit.remarks, remarks_on_given_lights(photographs, lit.lights.lights, lit.spheres));
    const auto doubt = doubt_of_linear(photographs, lit.lights.lights);
    if (doubt) lit.remarks.push_back(*doubt);
  }
  terminal.step("finding the sample");
  lit.photographs = without_pictures(photographs);
  lit.stack = light_stack(std::move(photographs), lit.lights.lights, lit.spheres);
  const bool may_ask = !lit.calibration || lit.calibration->sample_believed;
  const bool known_strengths =
      lit.lights.strengths_measured || (may_ask && balance_strengths(lit.stack));
  lit.lights.errors = rescaled(lit.lights.errors, lit.lights.lights, lit.stack.lights);
  if (!known_strengths) {
    for (auto& mode : unknown_strengths(lit.stack.lights)) lit.lights.errors.push_back(mode);
    lit.remarks.push_back(
        "The strengths of the lights are not known and were taken as equal, give or take a fifth; "
        "add a matte sphere, or pictures until there are five and more.");
  }
  lit.lights.lights = lit.stack.lights;
  lit.stack.light_errors = lit.lights.errors;
  add(lit.remarks, lit.photographs.remarks);
  if (!lit.calibration) add(lit.remarks, remarks_on_lights(lit.stack.lights));
  add(lit.remarks, remarks_on_clipping(lit.stack));
  add(lit.remarks,
      remarks_on_movement(lit.stack.images, lit.stack.lights, lit.spheres, lit.stack.mask));
  return lit;
}

}  // namespace hada
