#include "app/commands/calibrate.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/lit_capture.h"
#include "app/telling.h"
#include "capture/movement.h"
#include "io/lp_file.h"
#include "io/output.h"

namespace hada {
namespace {

std::vector<std::string> moved(Photographs photographs, const Calibration& calibration) {
  std::vector<Sphere> spheres;
  for (const auto& reading : calibration.readings) spheres.push_back(reading.sphere);
  photographs.linear = calibration.linear;
  const Photographs linear = linearized(std::move(photographs));
  return remarks_on_movement(linear.images, calibration.lights, spheres, linear.mask);
}

/// Hints in the place of those of the manifest, which keep kind and diameter if there are as many.
std::vector<CaptureFile::SphereHint> hints_of(const std::vector<BoxPx>& boxes,
                                              std::vector<CaptureFile::SphereHint> hints) {
  if (hints.size() != boxes.size()) hints.assign(boxes.size(), {});
  for (std::size_t i = 0; i < boxes.size(); ++i) hints[i].box = boxes[i];
  return hints;
}

}  // namespace

void calibrate_command(const CalibrateArguments& arguments, const Terminal& terminal) {
  Photographs photographs = load_folder(arguments.capture, terminal);
  if (!arguments.boxes.empty()) {
    photographs.file.spheres = hints_of(arguments.boxes, photographs.file.spheres);
  }
  terminal.step("reading the lights off the spheres");
  const Calibration calibration = calibrate(photographs);
  const std::string text = lights_text(lights_file(calibration, photographs.camera.extent.unit));
  const bool as_lp = is_lp(arguments.out);
  write_text(arguments.out, as_lp ? lp_text(calibration.lights) : text);
  for (const auto& reading : calibration.readings) {
    const Sphere& sphere = reading.sphere;
    terminal.say(fmt::format("{} sphere at ({:.2f}, {:.2f}) px, radius {} px", name_of(sphere.kind),
                             sphere.center_px.x(), sphere.center_px.y(),
                             with_sigma(sphere.radius_px, sphere.sigma_px)));
  }
  terminal.say(told(calibration));
  for (const auto& remark : calibration.remarks) terminal.say("note: " + remark);
  for (const auto& remark : moved(std::move(photographs), calibration)) {
    terminal.say("note: " + remark);
  }
  if (as_lp) {
    terminal.say(
        "note: A .lp file holds directions only: strengths, distances and how sure they are "
        "are lost; a name that ends in .json keeps them.");
  }
  terminal.say("wrote " + arguments.out.string());
  terminal.result(text);
}

}  // namespace hada
