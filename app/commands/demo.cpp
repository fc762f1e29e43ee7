#include "app/commands/demo.h"

#include "app/files.h"
#include "app/virtual_capture.h"
#include "app/whole_path.h"

namespace hada {

void demo_command(const DemoArguments& arguments, const Terminal& terminal) {
  const auto recipe_path = arguments.recipe.value_or(std::filesystem::path());
  const Recipe recipe =
      read_recipe(recipe_path.empty() ? shipped_recipe("sheet_and_spheres.json") : recipe_path);
  Output output(arguments.out);
  const auto folder = arguments.out / "capture";
  terminal.step("photographing " + recipe.name);
  write_capture(folder, virtual_capture(recipe), recipe);

  // From here on as with any capture: what was made is read again from its files.
  LitCapture lit = lit_capture(load_folder(folder, terminal), {}, terminal);
  WholePath path = whole_path(std::move(lit), recipe.name, {}, terminal);
  path.truth = check_truth(path, folder / "truth");
  terminal.step("writing the report");
  write_whole_path(path, output);
  tell(path, arguments.out, terminal);
  terminal.result(whole_path_text(path, arguments.out));
}

}  // namespace hada
