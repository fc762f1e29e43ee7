#pragma once

#include <functional>
#include <string>

#include "app/terminal.h"

namespace hada {

/// What a person asked for.
struct Request {
  std::function<void(const Terminal&)> work;  // empty: print `text` instead
  std::string text;                           // help or version
  Terminal::Manner manner;
  int threads = 0;  // 0: as many as there are cores
};

class Commands;

/// more    declares commands of rooms that this one may not know
/// throws  Error in one sentence for anything that is not a command of this program
Request parse_command_line(int count, const char* const* words, void (*more)(Commands&) = nullptr);

}  // namespace hada
