#include "app/whole_path.h"

#include "app/files.h"
#include "app/fit_material.h"
#include "app/reconstruction_files.h"
#include "app/report/report.h"
#include "app/telling.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "synth/synthesize.h"

namespace hada {

WholePath whole_path(LitCapture lit, const std::string& name, const WholePathOptions& options,
                     const Terminal& terminal) {
  WholePath path;
  path.name = name;
  terminal.step("reconstructing normals and height");
  path.reconstruction = reconstruct(lit.stack);
  path.lit = std::move(lit);
  const Surface& surface = path.reconstruction.surface;
  terminal.step("measuring the spectrum");
  path.measurement = measure(surface);
  terminal.step("fitting " + options.material);
  path.material = fit_material(options.material, surface, name, {.components = options.components});
  terminal.step("making more of the surface");
  path.material.seed = options.seed;
  path.synthesized = synthesize(path.material.material, surface.extent, options.seed);
  return path;
}

TruthCheck check_truth(const WholePath& path, const std::filesystem::path& folder) {
  return {compare(path.reconstruction.surface, read_surface(folder)),
          light_errors(path.lit.lights.lights, read_lights(folder / "lights.json").lights),
          read_material(folder / "material.json").material};
}

void write_whole_path(const WholePath& path, Output& output) {
  put_text(output, "lights.json", lights_text(path.lit.lights));
  put_reconstruction(output, "surface/", path.reconstruction, path.lit);
  put_text(output, "measure.json", measurement_text(path.measurement));
  put_text(output, "material.json", material_text(path.material));
  write_surface(output, "synth/", path.synthesized);
  put_previews(output, "synth/", path.synthesized);
  put_text(output, "report.html", report_html(path));
  output.commit();
}

void tell(const WholePath& path, const std::filesystem::path& folder, const Terminal& terminal) {
  terminal.say(told(path.lit));
  terminal.say(told(path.reconstruction));
  for (const auto& line : told(path.material)) terminal.say(line);
  if (path.truth) terminal.say(told(*path.truth));
  for (const auto* remarks :
       {&path.lit.remarks, &path.reconstruction.remarks, &path.material.remarks}) {
    for (const auto& remark : *remarks) terminal.say("note: " + remark);
  }
  terminal.say("open " + (folder / "report.html").string());
}

std::string whole_path_text(const WholePath& path, const std::filesystem::path& folder) {
  Json json = {{"hada", "run/1"},
               {"report", (folder / "report.html").string()},
               {"lights", Json::parse(lights_text(path.lit.lights))},
               {"reconstruction", Json::parse(surface_notes(path.reconstruction, path.lit))},
               {"material", Json::parse(material_text(path.material))}};
  if (path.truth) json["truth"] = Json::parse(comparison_text(path.truth->surface));
  return json.dump(1);
}

}  // namespace hada
