#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include <sys/types.h>

namespace hada {

/// A connected socket that neither waits for ever nor takes in more than it is told.
class DeadlineStream {
 public:
  explicit DeadlineStream(int socket) : socket_(socket) {}

  /// Whether a byte arrives within this time.
  bool wait(std::chrono::milliseconds time) const;
  /// From here on at most so many bytes are read, all of them within this time.
  void expect(std::size_t bytes, std::chrono::seconds time);
  /// From here on writing may take so long in all.
  void allow_answer(std::chrono::seconds time);
  /// From here on only each single write must go on within some seconds.
  void allow_endless_answer() { endless_ = true; }

  /// Whether time or bytes were used up, or the other side went away.
  bool is_broken() const { return broken_; }

  /// As of POSIX; -1 when time or bytes are used up.
  ssize_t read(char* to, std::size_t size);
  ssize_t write(const char* from, std::size_t size);

 private:
  using Clock = std::chrono::steady_clock;

  int socket_;
  std::vector<char> taken_ = {};  // read from the socket, from `next_` on not yet asked for
  std::size_t next_ = 0;
  std::size_t bytes_left_ = 0;
  Clock::time_point read_until_ = {};
  Clock::time_point write_until_ = {};
  bool endless_ = false;
  bool broken_ = false;
};

}  // namespace hada
