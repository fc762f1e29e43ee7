#include "app/commands/run.h"

namespace hada {
namespace {

std::string last_name(const std::filesystem::path& path) {
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

void run_command(const RunArguments& arguments, const Terminal& terminal) {
  material_named(arguments.path.material);  // an unknown name is said before anything is read
  Output output(arguments.out);
  Photographs photographs = load_folder(arguments.capture, terminal, arguments.pitch_mm);
  LitCapture lit = lit_capture(std::move(photographs), arguments.lights, terminal);
  const WholePath path =
      whole_path(std::move(lit), last_name(arguments.capture), arguments.path, terminal);
  terminal.step("writing the report");
  write_whole_path(path, output);
  tell(path, arguments.out, terminal);
  terminal.result(whole_path_text(path, arguments.out));
}

}  // namespace hada
