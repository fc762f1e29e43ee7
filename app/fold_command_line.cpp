#include "app/command_list.h"
#include "app/commands/fold.h"
#include "app/commands/fold_shape.h"

namespace hada {
namespace {

constexpr const char* pattern_words = "crease pattern: .fold, .cp, .opx or .svg";

template <class Arguments>
void add_pattern(CLI::App& command, Arguments& a) {
  command.add_option("pattern", a.input, pattern_words)->required();
}

template <class Arguments>
void add_thickness(CLI::App& command, Arguments& a) {
  command
      .add_option("--thickness", a.thickness,
                  "layers of a mesh lie so far apart, in the file's unit (default: 1/2000 of its "
                  "size; 0: in one plane)")
      ->check(CLI::NonNegativeNumber);
}

void add_flat_folding(Commands& commands, CLI::App& fold) {
  commands.add_to(fold, "check",
                  "Say whether a crease pattern folds flat, and if not, where it fails",
                  "hada fold check crane.fold", fold_check_command,
                  [](CLI::App& command, FoldCheckArguments& a) { add_pattern(command, a); });
  commands.add_to(fold, "flat", "Fold a crease pattern flat, with one order of its layers",
                  "hada fold flat crane.fold -o folded.fold", fold_flat_command,
                  [](CLI::App& command, FoldFlatArguments& a) {
                    add_pattern(command, a);
                    add_out(command, a, "FOLD file to write (default: flat.fold)");
                  });
  commands.add_to(fold, "states", "Count the orders in which the layers can lie",
                  "hada fold states crane.fold --above '3>7'", fold_states_command,
                  [](CLI::App& command, FoldStatesArguments& a) {
                    add_pattern(command, a);
                    command.add_option("--above", a.chosen,
                                       "'3>7': only states with face 3 over face 7");
                    add_out(command, a, "FOLD file for one of the states");
                  });
  commands.add_to(
      fold, "convert", "Write a crease pattern or folded form in another format",
      "hada fold convert crane.cp -o crane.fold", fold_convert_command,
      [](CLI::App& command, FoldConvertArguments& a) {
        add_pattern(command, a);
        add_thickness(command, a);
        add_out(command, a, "file to write: .fold, .obj, .stl, .ply, .gltf or .glb")->required();
      });
}

void add_shapes(Commands& commands, CLI::App& fold) {
  commands.add_to(
      fold, "simulate", "Drive the creases of a pattern: the shape in space that it takes",
      "hada fold simulate miura.fold --crease 12=60 -o miura.obj", fold_simulate_command,
      [](CLI::App& command, FoldSimulateArguments& a) {
        add_pattern(command, a);
        command.add_option("--percent", a.percent, "of each crease's own angle (default: 100)")
            ->check(CLI::Range(-100.0, 100.0));
        command.add_option("--crease", a.held,
                           "'12=60': hold edge 12 at 60 degrees, valleys > 0; all that are not "
                           "held follow");
        command.add_flag("--elastic", a.elastic,
                         "paper that stretches and bends a little (default: rigid faces)");
        command.add_option("--frames", a.frames, "states on the way, all in one FOLD file")
            ->check(CLI::Range(1, 1000));
        add_out(command, a, "file to write: .fold, .obj, .stl, .ply, .gltf or .glb");
      });
  commands.add_to(
      fold, "relax", "Make the faces of a folded form stiff again, some of its vertices pinned",
      "hada fold relax out/crane/model.fold --squash 0.5 --solver massed --pin 3 7",
      fold_relax_command, [](CLI::App& command, FoldRelaxArguments& a) {
        command.add_option("form", a.input, "folded form: .fold")->required();
        command.add_option("--solver", a.solver,
                           "faithful: springs as in the paper; massed: points as heavy as springs "
                           "meet there; exact: lengths and planes to rounding (default)");
        command.add_option("--pin", a.pinned, "vertices that stay");
        command.add_option("--squash", a.squash, "share of its height to press it to, before")
            ->check(CLI::Range(0.0, 1.0));
        command.add_option("--steps", a.most_steps, "of the springs, at most (default: 20000)")
            ->check(positive());
        add_out(command, a, "FOLD file to write (default: relaxed.fold)");
      });
  commands.add_to(
      fold, "replay", "Repeat a recorded sequence of folds: the model and its pictures",
      "hada fold replay data_synthetic/folds/crane.json --frames -o out/crane", fold_replay_command,
      [](CLI::App& command, FoldReplayArguments& a) {
        command.add_option("log", a.input, "log of folds (JSON)")->required();
        command.add_option("--steps", a.steps, "how many of its steps: fewer undo the last")
            ->check(CLI::NonNegativeNumber);
        command.add_flag("--frames", a.frames,
                         "a picture after every step, and its state as a frame of the FOLD file");
        command.add_option("--roll", a.roll_deg, "the picture's view, in its plane, degrees");
        command.add_option("--turn", a.turn_deg, "the picture's view, about its upright, degrees");
        command.add_option("--tilt", a.tilt_deg, "the picture's view, its top away, degrees");
        add_thickness(command, a);
        add_out(command, a, "folder for model.fold, model.obj and pictures (default: replayed)");
      });
  commands.add_to(
      fold, "measure", "Find the creases of a re-opened sheet and how far each is folded",
      "hada fold measure out/surface -o creases.fold", fold_measure_command,
      [](CLI::App& command, FoldMeasureArguments& a) {
        command
            .add_option("input", a.input,
                        "surface folder with normals, or folder of pictures beside a sphere")
            ->required();
        command.add_option("--lights", a.lights, "lights.json of a folder of pictures");
        command.add_option("--pitch", a.pitch_mm, "distance between pixels, mm")
            ->check(positive())
            ->type_name("MM");
        command
            .add_option("--smallest", a.smallest_deg,
                        "facets that differ by less are one, degrees (default: 1)")
            ->check(positive());
        add_out(command, a, "FOLD file to write (default: creases.fold)");
      });
}

}  // namespace

void add_folding(Commands& commands) {
  CLI::App& fold =
      commands.group("fold", "Fold paper: check, layers, angles, recorded folds, creases",
                     "hada fold check crane.fold");
  add_flat_folding(commands, fold);
  add_shapes(commands, fold);
}

}  // namespace hada
