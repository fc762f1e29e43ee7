#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace hada {

/// How a job stands. `lines` is what it said, the last one perhaps still being done.
struct JobState {
  int number = 0;              // 0: there was none yet
  std::string what = {};       // "reconstruct", for a person
  std::string state = "none";  // or "running", "done", "failed", "cancelled"
  std::vector<std::string> lines = {};
  int changes = 0;  // counts whatever changes here
};

/// Heavy work, one at a time: a command of this program in a process of its own, so that it can be
/// stopped at any moment and leaves nothing half written.
class Job {
 public:
  Job() = default;
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Starts `words` (the program first).
  /// throws  Error if one is running, or it cannot be started
  void start(const std::string& what, const std::vector<std::string>& words);
  /// Stops what is running; it ends soon after.
  void cancel();
  JobState state() const;
  /// The state once it differs from the one with so many changes, at most a second later.
  JobState wait(int changes) const;

 private:
  void follow(int terminal);
  void hear(const std::string& piece);

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::thread thread_;
  pid_t process_ = 0;  // while it runs
  bool stopped_ = false;
  bool line_is_open_ = false;
  JobState state_;
};

}  // namespace hada
