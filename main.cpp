#include <cstdio>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "app/command_line.h"
#include "core/error.h"
#include "core/parallel.h"
#include "io/output.h"
#include "studio/studio.h"

namespace {

void answer(int count, const char* const* words) {
  const hada::Request request = hada::parse_command_line(count, words, hada::add_studio);
  if (request.work) {
    hada::set_threads(request.threads);
    request.work(hada::Terminal(request.manner));
  } else {
    fmt::print(stdout, "{}", request.text);
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw hada::Error("standard output: cannot be written; check that the disk has room");
  }
}

int failed(const char* sentence) {
  std::fflush(stdout);
  fmt::print(stderr, "hada: {}\n", sentence);
  return 2;
}

}  // namespace

int main(int count, char** words) {
  try {
    hada::clean_up_on_interrupt();
    answer(count, words);
    return 0;
  } catch (const hada::Error& error) {
    return failed(error.what());
  } catch (const std::bad_alloc&) {
    return failed("there is not enough memory for this; use smaller pictures or fewer of them");
  } catch (const std::exception& error) {
    return failed(fmt::format("something unforeseen went wrong ({}); please report it with the "
                              "command that you used",
                              error.what())
                      .c_str());
  }
}
