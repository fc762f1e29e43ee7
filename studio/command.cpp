#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>

#include <spawn.h>
#include <unistd.h>

#include "app/command_list.h"
#include "core/error.h"
#include "io/output.h"
#include "studio/page.h"
#include "studio/studio.h"

namespace hada {
namespace {

// Lets the desktop open the address; where there is none the person does.
void open_browser(const std::string& address) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
  std::string program = "xdg-open", words = address;
  char* arguments[] = {program.data(), words.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ);
}

}  // namespace

void studio_command(const StudioArguments& arguments, const Terminal& terminal) {
  if (page_files().empty()) {
    throw Error(
        "this hada was built without its page: install nodejs and npm, then run cmake and build "
        "again");
  }
  auto studio = std::make_unique<Studio>(arguments);
  terminal.say("the studio is at " + studio->address() + "  (Ctrl-C ends it)");
  terminal.result("{\"hada\": \"studio/1\", \"address\": \"" + studio->address() + "\"}");
  std::fflush(stdout);
  if (!arguments.no_browser) open_browser(studio->address());
  // Ctrl-C ends the server in order, so that work is stopped and its scratch folder removed.
  std::promise<void> gone;
  do_first_on_interrupt([&studio, over = gone.get_future().share()] {
    studio->stop();
    over.wait_for(std::chrono::seconds(5));
  });
  studio->serve();
  studio.reset();
  gone.set_value();
  do_first_on_interrupt({});
}

void add_studio(Commands& commands) {
  commands.add(
      "studio", "Open a page in the browser: see, touch and fold", "hada studio photos",
      studio_command, [](CLI::App& command, StudioArguments& a) {
        command.add_option("folder", a.folder, "whose files may be opened (default: this one)");
        command.add_option("--port", a.port, "of 127.0.0.1 (default: any that is free)")
            ->check(CLI::Range(1, 65535));
        command.add_flag("--no-browser", a.no_browser, "only say the address, open nothing");
      });
}

}  // namespace hada
