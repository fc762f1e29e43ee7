#include "fit/knit_stiffness.h"

#include <fmt/format.h>

#include "app/commands/knit.h"
#include "app/knit_files.h"
#include "core/error.h"
#include "io/json.h"
#include "io/output.h"

namespace hada {

void knit_stiffness_command(const KnitStiffnessArguments& arguments, const Terminal& terminal) {
  const KnitCrossings crossings = read_crossings(arguments.crossings);
  std::vector<KnitState> states;
  for (const auto& state : crossings.states) {
    states.push_back({state.pull, state.stretch, state.places_mm});
  }
  terminal.step("fitting the rest of the knit");
  KnitStiffness found;
  try {
    found = knit_stiffness(crossings.net, crossings.repeat, crossings.clamp, states,
                           {.lengths_known = !arguments.lengths_unknown,
                            .frame_known = crossings.frame_known,
                            .load_N = arguments.load_N});
  } catch (const Error& error) {
    throw Error(arguments.crossings.string() + ": " + error.what());
  }
  Json json = {{"hada", "knit_stiffness/1"},
               {"parameters",
                {{"stiffness_ratio", found.ratio.value},
                 {"yarn_coefficient", found.continuity.value},
                 {"wale_mm", found.wale_mm.value},
                 {"course_mm", found.course_mm.value}}},
               {"sigma",
                {{"stiffness_ratio", found.ratio.sigma},
                 {"yarn_coefficient", found.continuity.sigma},
                 {"wale_mm", found.wale_mm.sigma},
                 {"course_mm", found.course_mm.sigma}}},
               {"noise_mm", found.noise_mm},
               {"starts", found.starts},
               {"agreeing", found.agreeing},
               {"remarks", found.remarks}};
  if (found.nylon_N_per_mm) {
    json["parameters"]["nylon_N_per_mm"] = found.nylon_N_per_mm->value;
    json["sigma"]["nylon_N_per_mm"] = found.nylon_N_per_mm->sigma;
  }
  write_text(arguments.out, json.dump(1) + "\n");
  terminal.say(fmt::format("stiffness ratio {:.3f} +- {:.3f}, yarn coefficient {:.4f} +- {:.4f}",
                           found.ratio.value, found.ratio.sigma, found.continuity.value,
                           found.continuity.sigma));
  if (found.nylon_N_per_mm) {
    terminal.say(fmt::format("nylon: {:.4g} +- {:.2g} N/mm", found.nylon_N_per_mm->value,
                             found.nylon_N_per_mm->sigma));
  }
  for (const std::string& remark : found.remarks) terminal.say(remark);
  terminal.say("wrote " + arguments.out.string());
  terminal.result(json.dump(1));
}

}  // namespace hada
