#include "app/commands/photograph.h"

#include <fmt/format.h>

#include "app/telling.h"
#include "app/virtual_capture.h"
#include "io/json.h"

namespace hada {

void photograph_command(const PhotographArguments& arguments, const Terminal& terminal) {
  const Recipe recipe = read_recipe(arguments.recipe);
  terminal.step("photographing " + recipe.name);
  const VirtualCapture capture = virtual_capture(recipe);
  write_capture(arguments.out, capture, recipe);
  terminal.say(fmt::format("took {} pictures of {} pixels of {}", capture.stack.images.size(),
                           size_text(capture.stack.extent()), recipe.name));
  terminal.say("wrote " + arguments.out.string() + ", the truth beside it in truth/");
  const Json json = {{"pictures", capture.stack.images.size()},
                     {"capture", arguments.out.string()},
                     {"truth", (arguments.out / "truth").string()}};
  terminal.result(json.dump(1));
}

}  // namespace hada
