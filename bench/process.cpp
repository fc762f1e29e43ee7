#include "bench/process.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hada {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()] =
        std::string(std::istreambuf_iterator<char>(in), {});
  }
  return files;
}

double anonymous_megabytes(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    if (word != "RssAnon:") continue;
    double kilobytes = 0.0;
    status >> kilobytes;
    return kilobytes / 1024.0;
  }
  return 0.0;
}

}  // namespace

ProcessCost run_process(const fs::path& program, const std::vector<std::string>& arguments,
                        int most_anonymous_mb) {
  const auto start = std::chrono::steady_clock::now();
  const std::string name = program.string();
  const pid_t child = fork();
  if (child == 0) {
    if (most_anonymous_mb > 0) {
      const rlim_t bytes = rlim_t(most_anonymous_mb) << 20;
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_DATA, &limit);
    }
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    std::vector<char*> words{const_cast<char*>(name.c_str())};
    for (const auto& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    execv(name.c_str(), words.data());
    _exit(127);
  }
  double anonymous = 0.0;
  std::jthread watcher([&](const std::stop_token& ended) {
    while (!ended.stop_requested()) {
      anonymous = std::max(anonymous, anonymous_megabytes(child));
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  });
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  watcher.request_stop();
  watcher.join();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, passed.count(),
          double(usage.ru_maxrss) / 1024.0, anonymous};
}

bool same_bytes(const fs::path& a, const fs::path& b) {
  return contents(a) == contents(b);
}

}  // namespace hada
