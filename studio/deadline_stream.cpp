#include "studio/deadline_stream.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>

namespace hada {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::seconds longest_write = 5s;

bool ready(int socket, short what, std::chrono::steady_clock::duration time) {
  pollfd entry{socket, what, 0};
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
  int answer = 0;
  do {
    answer = poll(&entry, 1, int(std::max<long long>(0, left)));
  } while (answer < 0 && errno == EINTR);
  return answer > 0;
}

}  // namespace

bool DeadlineStream::wait(std::chrono::milliseconds time) const {
  return next_ < taken_.size() || ready(socket_, POLLIN, time);
}

void DeadlineStream::expect(std::size_t bytes, std::chrono::seconds time) {
  bytes_left_ = bytes;
  read_until_ = Clock::now() + time;
  endless_ = false;
}

void DeadlineStream::allow_answer(std::chrono::seconds time) {
  write_until_ = Clock::now() + time;
}

ssize_t DeadlineStream::read(char* to, std::size_t size) {
  if (next_ == taken_.size()) {
    const bool may = bytes_left_ > 0 && Clock::now() < read_until_;
    broken_ = broken_ || !may || !ready(socket_, POLLIN, read_until_ - Clock::now());
    if (broken_) return -1;
    taken_.resize(std::min<std::size_t>(bytes_left_, 16384));
    next_ = 0;
    const ssize_t got = recv(socket_, taken_.data(), taken_.size(), 0);
    taken_.resize(std::size_t(std::max<ssize_t>(0, got)));
    broken_ = got <= 0;
    if (broken_) return got;
    bytes_left_ -= std::size_t(got);
  }
  const std::size_t given = std::min(size, taken_.size() - next_);
  std::memcpy(to, taken_.data() + next_, given);
  next_ += given;
  return ssize_t(given);
}

ssize_t DeadlineStream::write(const char* from, std::size_t size) {
  const auto left = write_until_ - Clock::now();
  const auto time =
      endless_ ? Clock::duration(longest_write) : std::min<Clock::duration>(left, longest_write);
  broken_ = broken_ || !ready(socket_, POLLOUT, time);
  if (broken_) return -1;
  const ssize_t sent = send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  broken_ = sent < 0;
  return sent;
}

}  // namespace hada
