#include "io/output.h"

#include <algorithm>
#include <cassert>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include <unistd.h>

#include "core/error.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

// What living Outputs would leave behind. The mutex is held while any of it changes, so that an
// interrupt meets either all of a commit or nothing of it.
struct Traces {
  std::mutex mutex;
  std::map<fs::path, std::vector<fs::path>> made_folders;  // by scratch folder, outermost first
  std::function<void()> first;                             // what an interrupt does before
};

Traces& traces() {
  static Traces& forever = *new Traces;  // outlives main: the interrupt may come during exit
  return forever;
}

void remove_folders_made(const std::vector<fs::path>& made) {
  std::error_code ignored;
  for (auto folder = made.rbegin(); folder != made.rend(); ++folder) fs::remove(*folder, ignored);
}

void remove_scratch(const fs::path& scratch) {
  // A thread that still writes may add a file behind the broom.
  constexpr int sweeps = 10;
  std::error_code ignored;
  for (int i = 0; i < sweeps && fs::exists(scratch, ignored); ++i) fs::remove_all(scratch, ignored);
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::string& advice) {
  throw Error(path.string() + ": " + what + "; " + advice);
}

// The folders on the way to `folder` that do not exist, outermost first.
std::vector<fs::path> missing_folders(fs::path folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  while (!folder.empty() && !fs::exists(folder, ignored)) {
    missing.insert(missing.begin(), folder);
    folder = folder.parent_path();
  }
  return missing;
}

fs::path new_scratch(const fs::path& folder) {
  std::string pattern = (folder / ".hada-XXXXXX").string();
  if (!mkdtemp(pattern.data())) {
    fail(folder, "nothing can be written there (" + std::generic_category().message(errno) + ")",
         "choose another folder or change its rights");
  }
  return pattern;
}

}  // namespace

Output::Output(const fs::path& folder)
    : folder_(fs::absolute(folder.empty() ? "." : folder).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // a slash at the end
  if (folder_.empty()) folder_ = "/";
  const std::lock_guard lock(traces().mutex);
  const auto made = missing_folders(folder_);
  try {
    std::error_code problem;
    fs::create_directories(folder_, problem);
    if (!fs::is_directory(folder_)) {
      if (fs::exists(folder_)) fail(folder_, "is a file, not a folder", "choose another name");
      fail(folder_, "the folder cannot be made (" + problem.message() + ")",
           "choose another place or change the rights");
    }
    scratch_ = new_scratch(folder_);
    traces().made_folders[scratch_] = made;
  } catch (const fs::filesystem_error& error) {
    remove_folders_made(made);
    fail(folder_, "cannot be reached (" + error.code().message() + ")", "choose another place");
  } catch (...) {
    remove_folders_made(made);
    throw;
  }
}

Output::~Output() {
  if (scratch_.empty()) return;
  const std::lock_guard lock(traces().mutex);
  remove_scratch(scratch_);
  remove_folders_made(traces().made_folders[scratch_]);
  traces().made_folders.erase(scratch_);
}

fs::path Output::file(const std::string& name) {
  assert(!scratch_.empty() && fs::path(name).is_relative());
  const fs::path path = scratch_ / name;
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  if (problem) {
    fail(folder_ / name, "cannot be written (" + problem.message() + ")", "check the free space");
  }
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  return path;
}

void Output::commit() {
  const std::lock_guard lock(traces().mutex);
  for (const auto& name : names_) {
    std::error_code ignored;
    if (!fs::exists(scratch_ / name, ignored)) {
      fail(folder_ / name, "was not written", "check the free space and try again");
    }
    if (fs::is_directory(folder_ / name, ignored)) {
      fail(folder_ / name, "is a folder, but a file of this name is to be written",
           "move it away or choose another folder");
    }
  }
  for (const auto& name : names_) {
    std::error_code problem;
    fs::create_directories((folder_ / name).parent_path(), problem);
    if (!problem) fs::rename(scratch_ / name, folder_ / name, problem);
    if (problem) {
      fail(folder_ / name, "cannot be replaced (" + problem.message() + ")",
           "choose another folder or change the rights");
    }
  }
  remove_scratch(scratch_);
  traces().made_folders.erase(scratch_);
  scratch_.clear();
}

void write_text(const fs::path& path, const std::string& text) {
  const auto write_to = [&](const fs::path& place) {
    std::ofstream stream(place, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) fail(path, "cannot be written", "check the free space and the rights");
  };
  std::error_code ignored;
  if (fs::exists(path, ignored) && fs::is_other(path, ignored)) return write_to(path);
  if (path.filename().empty() || fs::is_directory(path, ignored)) {
    fail(path, "is a folder", "name a file inside it");
  }
  Output output(path.parent_path());
  write_to(output.file(path.filename().string()));
  output.commit();
}

void do_first_on_interrupt(std::function<void()> work) {
  const std::lock_guard lock(traces().mutex);
  traces().first = std::move(work);
}

void clean_up_on_interrupt() {
  // Threads inherit the mask of their maker: blocked here, the signals reach only the one below.
  sigset_t interrupts;
  sigemptyset(&interrupts);
  sigaddset(&interrupts, SIGINT);
  sigaddset(&interrupts, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &interrupts, nullptr);
  std::thread([interrupts] {
    int signal = 0;
    sigwait(&interrupts, &signal);
    std::function<void()> first;
    {
      const std::lock_guard lock(traces().mutex);
      first = traces().first;
    }
    if (first) first();
    traces().mutex.lock();  // and never let go: nobody may begin a commit now
    std::vector<fs::path> folders;
    for (const auto& [scratch, made] : traces().made_folders) {
      remove_scratch(scratch);
      folders.insert(folders.end(), made.begin(), made.end());
    }
    // One output may lie inside the folder that another made: a folder follows those around it.
    std::sort(folders.begin(), folders.end());
    remove_folders_made(folders);
    constexpr int interrupted = 130;
    _exit(interrupted);
  }).detach();
}

}  // namespace hada
