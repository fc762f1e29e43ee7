#include <algorithm>

#include <fmt/format.h>

#include "app/commands/fold_shape.h"
#include "app/draw/sheet_picture.h"
#include "app/files.h"
#include "app/fold_log_file.h"
#include "app/fold_model.h"
#include "app/sheet_mesh.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "sheet/arrangement.h"
#include "sheet/crossing.h"
#include "sheet/fold_log.h"
#include "sheet/folded_flat.h"

namespace hada {
namespace {

// What the steps of a log did to the paper that paper does not do.
struct Passing {
  std::size_t pairs = 0;       // of faces that pass through each other, over all states
  std::size_t disordered = 0;  // flat states whose layers have no order that paper can have
  std::size_t flat = 0;
};

Passing passing_of(const std::vector<FoldState>& states) {
  Passing passing;
  for (const FoldState& state : states) {
    passing.pairs += crossing_faces(state.sheet, 1e-6 * size_of(state.sheet.flat)).size();
    passing.flat += state.flat;
    passing.disordered += !order_flaw(state).empty();
  }
  return passing;
}

}  // namespace

void fold_replay_command(const FoldReplayArguments& arguments, const Terminal& terminal) {
  FoldLog log = read_fold_log(arguments.input);
  if (arguments.steps >= 0 && arguments.steps < int(log.steps.size())) {
    log.steps.resize(std::size_t(arguments.steps));
  }
  terminal.step("folding");
  const auto states = replayed(log);
  const FoldState& last = states.back();
  Output output(arguments.out);
  const FoldFile file =
      arguments.frames ? fold_sequence(log.title, states) : fold_model(log.title, last);
  const double thickness = arguments.thickness.value_or(paper_thickness(file.frames[0]));
  put_text(output, "model.fold", fold_text(file));
  write_mesh(output, "model.obj", mesh_of(file.frames[0], thickness));
  const SheetView view{arguments.roll_deg, arguments.turn_deg, arguments.tilt_deg, 480};
  put_picture(output, "model.png", sheet_picture(file.frames[0], view));
  for (std::size_t i = 0; arguments.frames && i < states.size(); ++i) {
    put_picture(output, fmt::format("step_{:02}.png", i),
                sheet_picture(fold_model("", states[i]).frames[0], view));
  }
  output.commit();
  const Passing passing = passing_of(states);
  Json contacts = Json::array();
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (!states[i].contact) continue;
    const FoldContact& met = *states[i].contact;
    terminal.say(fmt::format("step {} stopped at {:.2f} of {:g} degrees: faces {} and {} met", i,
                             met.degrees, log.steps[i - 1].degrees, met.face, met.other));
    contacts.push_back({{"step", i}, {"degrees", met.degrees}, {"faces", {met.face, met.other}}});
  }
  terminal.say(fmt::format("{}: {} steps, {} faces, {} pairs of faces pass through each other",
                           log.title, log.steps.size(), last.sheet.faces(), passing.pairs));
  terminal.say(fmt::format("the layers are in order in {} of the {} flat states",
                           passing.flat - passing.disordered, passing.flat));
  if (!last.order.empty()) {
    terminal.say(fmt::format("layers of model.obj lie {:.3g} apart", thickness));
  }
  terminal.say("wrote " + arguments.out.string());
  terminal.result(Json{
      {"hada", "fold_replay/1"},
      {"title", log.title},
      {"steps", log.steps.size()},
      {"faces", last.sheet.faces()},
      {"flat", last.flat},
      {"crossing_pairs", passing.pairs},
      {"flat_states", passing.flat},
      {"disordered_states", passing.disordered},
      {"contacts",
       contacts}}.dump(1));
}

}  // namespace hada
