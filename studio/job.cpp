#include "studio/job.h"

#include <chrono>
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"

namespace hada {
namespace {

constexpr std::size_t most_lines = 200;

// A terminal for the process to speak to: it tells its steps to terminals only.
int open_terminal() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) {
    if (terminal >= 0) close(terminal);
    throw Error("no terminal can be opened for the work; close other programs");
  }
  return terminal;
}

pid_t spawned(const std::vector<std::string>& words, int terminal) {
  char name[128];
  if (ptsname_r(terminal, name, sizeof name) != 0) return 0;
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, name, O_RDWR | O_NOCTTY, 0);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  // The server waits for signals in a thread of its own; the process takes them as usual.
  posix_spawnattr_t manner;
  posix_spawnattr_init(&manner);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&manner, &none);
  posix_spawnattr_setflags(&manner, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  if (posix_spawn(&process, words[0].c_str(), &files, &manner, arguments.data(), environ) != 0) {
    process = 0;
  }
  posix_spawnattr_destroy(&manner);
  posix_spawn_file_actions_destroy(&files);
  return process;
}

}  // namespace

Job::~Job() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void Job::start(const std::string& what, const std::vector<std::string>& words) {
  const std::lock_guard lock(mutex_);
  if (process_ != 0) {
    throw Error("\"" + state_.what + "\" is being done; wait for it, or cancel it");
  }
  if (thread_.joinable()) thread_.join();
  const int terminal = open_terminal();
  process_ = spawned(words, terminal);
  if (process_ == 0) {
    close(terminal);
    throw Error(words[0] + ": cannot be started");
  }
  stopped_ = line_is_open_ = false;
  state_ = {state_.number + 1, what, "running", {}, state_.changes + 1};
  changed_.notify_all();
  thread_ = std::thread([this, terminal] { follow(terminal); });
}

void Job::cancel() {
  const std::lock_guard lock(mutex_);
  if (process_ == 0) return;
  stopped_ = true;
  kill(process_, SIGTERM);  // upon which the program removes what it has begun to write
}

JobState Job::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

JobState Job::wait(int changes) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::seconds(1), [&] { return state_.changes != changes; });
  return state_;
}

void Job::follow(int terminal) {
  char bytes[4096];
  for (ssize_t got = 0; (got = read(terminal, bytes, sizeof bytes)) > 0;) {
    hear(std::string(bytes, std::size_t(got)));
  }
  int status = 0;
  waitpid(process_, &status, 0);
  close(terminal);
  const std::lock_guard lock(mutex_);
  process_ = 0;
  const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  state_.state = well ? "done" : stopped_ ? "cancelled" : "failed";
  ++state_.changes;
  changed_.notify_all();
}

void Job::hear(const std::string& piece) {
  const std::lock_guard lock(mutex_);
  auto& lines = state_.lines;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const char c = piece[i];
    if (c == '\033') {  // of a step that is over: "clear to the end of the line"
      i = std::min(piece.find('K', i), piece.size());
    } else if (c == '\n' || c == '\r') {
      line_is_open_ = false;
    } else {
      if (!line_is_open_ && lines.size() < most_lines) lines.emplace_back();
      line_is_open_ = true;
      if (!lines.empty() && lines.back().size() < 500) lines.back() += c;
    }
  }
  ++state_.changes;
  changed_.notify_all();
}

}  // namespace hada
