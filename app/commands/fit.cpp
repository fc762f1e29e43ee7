#include "app/commands/fit.h"

#include <fmt/format.h>

#include "app/draw/crossings_picture.h"
#include "app/files.h"
#include "app/fit_material.h"
#include "app/knit_files.h"
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

// The photographs that --pulled names.
std::optional<PulledKnitInput> pulled_input(const FitArguments& a) {
  if (a.pulled.empty()) return std::nullopt;
  if (a.material != Knit<>::name) {
    throw Error("--pulled: photographs of knit that is pulled; leave it out for " + a.material);
  }
  if (a.stretches.size() != a.pulled.size()) {
    throw Error("--stretch: give the stretch of each photograph of --pulled, in their order");
  }
  if (a.courses < 3 || a.wales < 3) {
    throw Error("--courses and --wales: say how many the pulled piece has, 3 at least");
  }
  PulledKnitInput input{{}, {a.courses, a.wales, clamp_named(a.clamp)}};
  for (std::size_t s = 0; s < a.pulled.size(); ++s) {
    input.photographs.push_back(
        {read_surface(a.pulled[s], a.pitch_mm), pull_named(a.along), a.stretches[s]});
    if (input.photographs.back().picture.albedo.empty()) {
      throw Error(a.pulled[s].string() + ": holds no brightness to find crossings by");
    }
  }
  return input;
}

// What was tracked: the crossings, and a picture of them over each photograph.
void write_crossings(const FitArguments& a, const PulledKnitInput& input) {
  KnitCrossings crossings{input.found.net, input.found.repeat, input.piece.clamp, false, {}};
  Output output(a.crossings);
  for (std::size_t s = 0; s < input.photographs.size(); ++s) {
    const KnitState& state = input.found.states[s];
    crossings.states.push_back({state.pull, state.stretch, state.places});
    put_picture(output, fmt::format("tracked_{}.png", s + 1),
                crossings_picture(input.photographs[s].picture, crossings.net.wales, state.places));
  }
  put_text(output, "crossings.json", crossings_text(crossings));
  output.commit();
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
  auto pulled = pulled_input(arguments);
  terminal.step("fitting " + arguments.material);
  ForgedFit forged;
  const MaterialFile file =
      fit_material(arguments.material, surface, last_name(arguments.input),
                   {.components = arguments.components,
                    .lens_blur_px = arguments.lens_blur_px,
                    .ridges = arguments.ridges,
                    .view = arguments.view,
                    .face = face ? &*face : nullptr,
                    .pulled = pulled ? &*pulled : nullptr,
                    .forged = &forged,
                    .progress = [&](const std::string& stage) {
                      terminal.step("fitting " + arguments.material + ": " + stage);
                    }});
  if (pulled && !arguments.crossings.empty()) write_crossings(arguments, *pulled);
  const std::string text = material_text(file);
  write_text(arguments.out, text);
  if (!arguments.report.empty())
    write_text(arguments.report, forged_page(last_name(arguments.input), surface, forged));
  for (const auto& line : told(file)) terminal.say(line);
  for (const auto& remark : file.remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  if (pulled && !arguments.crossings.empty()) {
    terminal.say("wrote " + arguments.crossings.string());
  }
  if (!arguments.report.empty()) terminal.say("wrote " + arguments.report.string());
  terminal.result(text);
}

}  // namespace hada
