#include "app/command_list.h"
#include "app/commands/knit.h"

namespace hada {
namespace {

constexpr int most_stitches = 2000;  // each way

template <class Arguments>
void add_material(CLI::App& command, Arguments& a) {
  command.add_option("--material", a.material,
                     "material file of knit (default: the paper's yarns, 10 to 1)");
}

void add_pull(Commands& commands, CLI::App& knit) {
  commands.add_to(
      knit, "pull", "Pull a flat knit between clamps: where its crossings come to rest",
      "hada knit pull --stretch 1.2 1.5 --along course -o out/pulled", knit_pull_command,
      [](CLI::App& command, KnitPullArguments& a) {
        add_material(command, a);
        command.add_option("--courses", a.courses, "rows of stitches (default: 10)")
            ->check(CLI::Range(3, most_stitches));
        command.add_option("--wales", a.wales, "columns of stitches (default: 10)")
            ->check(CLI::Range(3, most_stitches));
        command.add_option("--stretch", a.stretches, "length over that at rest (default: 1.5)")
            ->check(CLI::Range(1.0, 10.0));
        command.add_option("--along", a.along, "wale (default) or course")
            ->check(CLI::IsMember({"wale", "course"}));
        command.add_option("--clamp", a.clamp, "uniform (default): whole edges; or three-points")
            ->check(CLI::IsMember({"uniform", "three-points"}));
        command.add_flag("--as-the-paper", a.as_the_paper, "by the paper's steps, not Newton's");
        command
            .add_option("--noise", a.noise, "of the crossings written, over a wale (default: 0)")
            ->check(CLI::Range(0.0, 1.0));
        command.add_option("--seed", a.seed, "of the noise (default: 1)");
        command
            .add_option("--photographs", a.photograph_pitch,
                        "write made photographs too, of the knit at rest and of each state, with "
                        "this distance between pixels")
            ->check(positive())
            ->type_name("MM");
        add_out(command, a, "folder to write (default: pulled)");
      });
}

void add_wear(Commands& commands, CLI::App& knit) {
  commands.add_to(
      knit, "wear",
      "Draw a tube of knit or a stocking over a body: yarns, density, pressure, see-through",
      "hada knit wear leg.obj --courses 150 --wales 150 -o out/worn", knit_wear_command,
      [](CLI::App& command, KnitWearArguments& a) {
        command.add_option("body", a.body,
                           "mesh: .obj, .ply, .gltf or .glb (default: a leg of 700 mm)");
        add_material(command, a);
        WearOptions& o = a.options;
        command
            .add_option("--shell", a.shell,
                        "tube (default), open at both ends; or stocking, with heel and toe, for a "
                        "leg that stands on its foot")
            ->check(CLI::IsMember({"tube", "stocking"}));
        command.add_option("--courses", o.courses, "rounds of stitches (default: 150)")
            ->check(CLI::Range(3, most_stitches));
        command.add_option("--wales", o.wales, "stitches of a ring (default: 150)")
            ->check(CLI::Range(3, most_stitches));
        command.add_option("--axis", a.axis, "along which it is drawn: x, y (default) or z")
            ->check(CLI::IsMember({"x", "y", "z"}));
        command.add_option(
            "--from", o.from_mm,
            "height along the axis where a tube begins, mm (default: nearly at the end)");
        command.add_option(
            "--to", o.to_mm,
            "height where it ends, or the welt of a stocking, mm (default: nearly at the end)");
        command
            .add_option("--girth", o.girth,
                        "of the knit at rest, over the smallest of the body, or of its ankle "
                        "(default: 0.7)")
            ->check(CLI::Range(0.01, 100.0));
        command
            .add_option("--length", o.length,
                        "of the knit at rest, over that when worn (default: 0.6)")
            ->check(CLI::Range(0.01, 100.0));
        command
            .add_option("--friction", o.friction,
                        "coefficient: a point stays that is pulled along by less than this times "
                        "what presses it on (default: 0)")
            ->check(CLI::NonNegativeNumber);
        command.add_option("--yarn-radius", a.yarn_radius_mm, "mm (default: 0.1 of a wale)")
            ->check(positive());
        command
            .add_option("--nylon-stiffness", a.nylon_N_per_mm,
                        "of a spring of nylon, N/mm: pressures are then in kPa")
            ->check(positive());
        command.add_flag("--loops", a.loops,
                         "write loops.glb too: the yarn in curved loops, thin enough to pass");
        command.add_option("--turn", a.turn_deg, "of the pictures about the axis, degrees");
        command.add_option("--rows", a.picture_rows, "of the pictures (default: 720)")
            ->check(CLI::Range(100, 8000));
        add_out(command, a, "folder to write (default: worn)");
      });
}

void add_stiffness(Commands& commands, CLI::App& knit) {
  commands.add_to(
      knit, "stiffness", "Find how stiff yarns are from crossings at known stretches",
      "hada knit stiffness out/pulled/crossings.json --load 2.5 -o stiffness.json",
      knit_stiffness_command, [](CLI::App& command, KnitStiffnessArguments& a) {
        command.add_option("crossings", a.crossings, "places of the crossings (JSON)")->required();
        command
            .add_option("--load", a.load_N,
                        "on the clamps in the last state, N: tells stiffness in N/mm")
            ->check(positive());
        command.add_flag("--lengths-unknown", a.lengths_unknown, "find lengths at rest as well");
        add_out(command, a, "file to write (default: stiffness.json)");
      });
}

}  // namespace

void add_knitting(Commands& commands) {
  CLI::App& knit =
      commands.group("knit", "Pull, wear and calibrate plain knit", "hada knit wear -o out/worn");
  add_pull(commands, knit);
  add_wear(commands, knit);
  add_stiffness(commands, knit);
}

}  // namespace hada
