#include "app/virtual_capture.h"

#include <variant>

#include <fmt/format.h>

#include "app/files.h"
#include "app/material_file.h"
#include "capture/photograph.h"
#include "io/image_file.h"
#include "io/lights_file.h"
#include "io/surface_file.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

std::string picture_name(std::size_t index, int bits) {
  return fmt::format("light_{:02}.{}", index + 1, bits == 32 ? "exr" : "png");
}

CaptureFile manifest(const std::filesystem::path& folder, std::size_t pictures, const Rig& rig) {
  CaptureFile file;
  file.folder = folder;
  file.encoding = "linear";
  file.pitch_mm = rig.pitch_mm;
  for (std::size_t k = 0; k < pictures; ++k) {
    const std::string name = picture_name(k, rig.bits);
    file.pictures.push_back({folder / name, name, {}, {}});
  }
  return file;
}

// A sheet is cut from a larger one. A field that tiles is one period, in which the longest waves
// come out stronger or weaker than their law says, by luck that a fit cannot see.
Surface sheet_of(const Recipe& recipe) {
  if (std::holds_alternative<Wrinkle<>>(recipe.material)) {
    return synthesize_window(recipe.material, recipe.sheet, {0.0, 0.0}, recipe.sheet_seed);
  }
  return synthesize(recipe.material, recipe.sheet, recipe.sheet_seed);
}

}  // namespace

VirtualCapture virtual_capture(const Recipe& recipe) {
  const Surface sheet = sheet_of(recipe);
  VirtualCapture capture{photograph(sheet, recipe.rig), seen(sheet, recipe.rig)};
  for (std::size_t k = 0; k < capture.stack.lights.size(); ++k) {
    capture.stack.lights[k].image = picture_name(k, recipe.rig.bits);
  }
  return capture;
}

Photographs as_loaded(const VirtualCapture& capture, const Recipe& recipe) {
  Photographs photographs;
  photographs.file = manifest(recipe.name, capture.stack.images.size(), recipe.rig);
  photographs.camera = capture.stack.camera;
  photographs.images = capture.stack.images;
  for (const auto& samples : capture.stack.samples) {
    Mask saturated(samples.rows(), samples.cols());
    for (std::size_t i = 0; i < samples.size(); ++i) saturated[i] = samples[i] == Sample::saturated;
    photographs.saturated.push_back(std::move(saturated));
  }
  photographs.bits = recipe.rig.bits;
  return photographs;
}

void write_capture(const std::filesystem::path& folder, const VirtualCapture& capture,
                   const Recipe& recipe) {
  Output output(folder);
  const CaptureFile file = manifest(folder, capture.stack.images.size(), recipe.rig);
  for (std::size_t k = 0; k < file.pictures.size(); ++k) {
    const auto path = output.file(file.pictures[k].name);
    if (recipe.rig.bits == 32) {
      write_exr(path, capture.stack.images[k]);
    } else {
      write_integer_image(path, capture.stack.images[k], recipe.rig.bits);
    }
  }
  put_text(output, "capture.json", capture_text(file));
  write_surface(output, "truth/", capture.truth);
  LightsFile lights;
  lights.lights = capture.stack.lights;
  lights.encoding = "linear";
  put_text(output, "truth/lights.json", lights_text(lights));
  MaterialFile material;
  material.material = recipe.material;
  material.seed = recipe.sheet_seed;
  put_text(output, "truth/material.json", material_text(material));
  output.commit();
}

}  // namespace hada
