#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "app/commands/fold_shape.h"
#include "app/fold_input.h"
#include "app/sheet_mesh.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "io/output.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

HeldCrease held_from(const std::string& text) {
  HeldCrease held;
  const std::size_t sign = text.find('=');
  const char* end = text.data() + std::min(sign, text.size());
  const auto [last, problem] = std::from_chars(text.data(), end, held.edge);
  char* rest = nullptr;
  const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
  const double angle = std::strtod(number.c_str(), &rest);
  if (problem != std::errc{} || last != end || number.empty() || *rest != '\0' ||
      !(std::abs(angle) <= 180.0)) {
    throw Error("--crease " + text +
                ": must be an edge and an angle from -180 to 180, as in '12=90'");
  }
  held.angle = angle * degree;
  return held;
}

}  // namespace

void fold_simulate_command(const FoldSimulateArguments& arguments, const Terminal& terminal) {
  FoldFile file;
  Sheet sheet = read_sheet(arguments.input, &file.title);
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) sheet.folded[v] << sheet.flat[v], 0.0;
  SimulateOptions options;
  options.rigid = !arguments.elastic;
  for (const std::string& text : arguments.held) options.held.push_back(held_from(text));
  const Sheet flat = sheet;
  Simulated shape;
  const int frames = std::max(arguments.frames, 1);
  options.stages = std::max(20 / frames, 2);
  for (int frame = 1; frame <= frames; ++frame) {
    const double share = double(frame) / frames;
    SimulateOptions part = options;
    part.share = share * arguments.percent / 100.0;
    for (HeldCrease& held : part.held) held.angle *= share;
    terminal.step(fmt::format("folding: {} of {}", frame, frames));
    shape = simulate(sheet, part);
    sheet.folded = shape.places;
    FoldFrame state = folded_frame(sheet);
    for (std::size_t e = 0; e < shape.angles.size(); ++e) {
      state.fold_angle_deg[e] = shape.angles[e] / degree;
    }
    file.frames.push_back(std::move(state));
  }
  // The last state first: a FOLD file shows its key frame.
  std::swap(file.frames.front(), file.frames.back());
  file.frames.push_back(flat_frame(flat));
  if (arguments.out.extension() == ".fold") {
    write_text(arguments.out, fold_text(file));
  } else {
    write_mesh(arguments.out, mesh_of(file.frames[0], 0.0));
  }
  terminal.say(fmt::format("{} faces, {} steps: strain {:.1e}, out of plane {:.1e}", sheet.faces(),
                           shape.steps, shape.strain, shape.planarity));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(Json{{"hada", "fold_simulate/1"},
                       {"faces", sheet.faces()},
                       {"steps", shape.steps},
                       {"strain", shape.strain},
                       {"planarity", shape.planarity}}
                      .dump(1));
}

}  // namespace hada
