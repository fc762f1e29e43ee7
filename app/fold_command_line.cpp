#include "app/command_list.h"
#include "app/commands/fold.h"

namespace hada {
namespace {

constexpr const char* pattern_words = "crease pattern: .fold, .cp, .opx or .svg";

template <class Arguments>
void add_pattern(CLI::App& command, Arguments& a) {
  command.add_option("pattern", a.input, pattern_words)->required();
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
  commands.add_to(fold, "convert", "Write a crease pattern or folded form in another format",
                  "hada fold convert crane.cp -o crane.fold", fold_convert_command,
                  [](CLI::App& command, FoldConvertArguments& a) {
                    add_pattern(command, a);
                    add_out(command, a, "file to write: .fold")->required();
                  });
}

}  // namespace

void add_folding(Commands& commands) {
  CLI::App& fold =
      commands.group("fold", "Fold paper: check, layers, angles, recorded folds, creases",
                     "hada fold check crane.fold");
  add_flat_folding(commands, fold);
}

}  // namespace hada
