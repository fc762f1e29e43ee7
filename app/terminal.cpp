#include "app/terminal.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace hada {

Terminal::~Terminal() {
  clear_step();
}

void Terminal::say(const std::string& line) const {
  if (manner_.quiet || manner_.json) return;
  clear_step();
  fmt::print(stdout, "{}\n", line);
}

void Terminal::result(const std::string& json) const {
  if (!manner_.json) return;
  clear_step();
  fmt::print(stdout, "{}\n", json);
}

void Terminal::step(const std::string& doing) const {
  if (manner_.quiet || isatty(STDERR_FILENO) == 0) return;
  clear_step();
  std::fflush(stdout);
  fmt::print(stderr, "{} ...", doing);
  std::fflush(stderr);
  step_shown_ = true;
}

void Terminal::clear_step() const {
  if (!step_shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  step_shown_ = false;
}

}  // namespace hada
