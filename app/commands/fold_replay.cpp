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
#include "sheet/crossing.h"
#include "sheet/fold_log.h"

namespace hada {
void fold_replay_command(const FoldReplayArguments& arguments, const Terminal& terminal) {
  FoldLog log = read_fold_log(arguments.input);
  if (arguments.steps >= 0 && arguments.steps < int(log.steps.size())) {
    log.steps.resize(std::size_t(arguments.steps));
  }
  terminal.step("folding");
  const auto states = replayed(log);
  const FoldState& last = states.back();
  Output output(arguments.out);
  const FoldFile file = fold_model(log.title, last);
  put_text(output, "model.fold", fold_text(file));
  write_mesh(output, "model.obj", mesh_of(file.frames[0]));
  const SheetView view{arguments.roll_deg, arguments.turn_deg, arguments.tilt_deg, 480};
  put_picture(output, "model.png", sheet_picture(file.frames[0], view));
  for (std::size_t i = 0; arguments.frames && i < states.size(); ++i) {
    put_picture(output, fmt::format("step_{:02}.png", i),
                sheet_picture(fold_model("", states[i]).frames[0], view));
  }
  output.commit();
  const auto crossing = crossing_faces(last.sheet);
  terminal.say(fmt::format("{}: {} steps, {} faces, {} pairs of faces pass through each other",
                           log.title, log.steps.size(), last.sheet.faces(), crossing.size()));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(Json{{"hada", "fold_replay/1"},
                       {"title", log.title},
                       {"steps", log.steps.size()},
                       {"faces", last.sheet.faces()},
                       {"flat", last.flat},
                       {"crossing_pairs", crossing.size()}}
                      .dump(1));
}

}  // namespace hada
