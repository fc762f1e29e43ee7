#include "app/commands/fit.h"

#include "app/fit_material.h"
#include "app/report/forged_page.h"
#include "app/telling.h"
#include "core/error.h"
#include "io/output.h"
#include "io/surface_file.h"

namespace hada {
namespace {

// "out/sheet/surface/" and "out/sheet/surface" are both known as "surface".
std::string last_name(const std::filesystem::path& path) {
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

void fit_command(const FitArguments& arguments, const Terminal& terminal) {
  material_named(arguments.material);  // an unknown name is said before anything is read
  if (!arguments.report.empty() && arguments.material != Forged<>::name) {
    throw Error("--report: a page is written about forged steel; leave it out for " +
                arguments.material);
  }
  if (arguments.ridges && arguments.material != Wrinkle<>::name)
    throw Error("--ridges: they lie over wrinkles; leave it out for " + arguments.material);
  terminal.step("reading " + arguments.input.string());
  const Surface surface = read_surface(arguments.input, arguments.pitch_mm);
  std::optional<Surface> face;
  if (!arguments.face.empty()) face = read_surface(arguments.face, arguments.pitch_mm);
  terminal.step("fitting " + arguments.material);
  ForgedFit forged;
  const MaterialFile file =
      fit_material(arguments.material, surface, last_name(arguments.input),
                   {.components = arguments.components,
                    .lens_blur_px = arguments.lens_blur_px,
                    .ridges = arguments.ridges,
                    .view = arguments.view,
                    .face = face ? &*face : nullptr,
                    .forged = &forged,
                    .progress = [&](const std::string& stage) {
                      terminal.step("fitting " + arguments.material + ": " + stage);
                    }});
  const std::string text = material_text(file);
  write_text(arguments.out, text);
  if (!arguments.report.empty())
    write_text(arguments.report, forged_page(last_name(arguments.input), surface, forged));
  for (const auto& line : told(file)) terminal.say(line);
  for (const auto& remark : file.remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  if (!arguments.report.empty()) terminal.say("wrote " + arguments.report.string());
  terminal.result(text);
}

}  // namespace hada
