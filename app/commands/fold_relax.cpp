#include <fmt/format.h>

#include "app/commands/fold_shape.h"
#include "app/fold_input.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "io/output.h"
#include "sheet/relaxed.h"
#include "sheet/simulate.h"

namespace hada {
namespace {

StiffSolver solver_named(const std::string& name) {
  if (name == "faithful") return StiffSolver::faithful;
  if (name == "massed") return StiffSolver::massed;
  if (name == "exact") return StiffSolver::exact;
  throw Error("--solver " + name + ": choose from: faithful, massed, exact");
}

}  // namespace

void fold_relax_command(const FoldRelaxArguments& arguments, const Terminal& terminal) {
  StiffOptions options;
  options.solver = solver_named(arguments.solver);
  options.pinned = arguments.pinned;
  options.most_steps = arguments.most_steps;
  FoldFile file;
  Sheet sheet = read_sheet(arguments.input, &file.title);
  for (Eigen::Vector3d& p : sheet.folded) p.z() *= arguments.squash;
  terminal.step("relaxing");
  const StiffSheet stiff = stiffened(sheet, options);
  sheet.folded = stiff.places;
  sheet.fold_angles = edge_angles(sheet, sheet.folded);
  file.frames = {folded_frame(sheet), flat_frame(sheet)};
  write_text(arguments.out, fold_text(file));
  terminal.say(fmt::format(
      "{} faces, {} steps{}: strain {:.1e}, out of plane {:.1e}", sheet.faces(), stiff.steps,
      stiff.substeps > 1 ? fmt::format(", each cut into {} to stay stable", stiff.substeps) : "",
      stiff.strain, stiff.planarity));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(Json{{"hada", "fold_relax/1"},
                       {"solver", arguments.solver},
                       {"steps", stiff.steps},
                       {"substeps", stiff.substeps},
                       {"strain", stiff.strain},
                       {"planarity", stiff.planarity}}
                      .dump(1));
}

}  // namespace hada
