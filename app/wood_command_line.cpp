#include "app/command_list.h"
#include "app/commands/block.h"

namespace hada {

void add_wood(Commands& commands) {
  commands.add("block", "Find the solid that the faces of a block of wood are cut from, and cut it",
               "hada block block.json --leave-out radial -o out/block", block_command,
               [](CLI::App& command, BlockArguments& a) {
                 command
                     .add_option("block", a.block,
                                 "block file: pictures, where they lie, and cuts to predict")
                     ->required();
                 command.add_option(
                     "--leave-out", a.left_out,
                     "name of a face to predict instead of looking at it; may be repeated");
                 add_out(command, a, "folder to write (default: block)");
               });
}

}  // namespace hada
