#pragma once

#include <string>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "studio/studio.h"

namespace hada {

/// A studio that runs while the test does.
class RunningStudio {
 public:
  explicit RunningStudio(const std::filesystem::path& folder)
      : studio_({.folder = folder, .no_browser = true, .program = HADA_PROGRAM}),
        thread_([this] { studio_.serve(); }) {
    const std::string address = studio_.address();  // http://127.0.0.1:port/token/
    const std::size_t colon = address.find(':', 7), slash = address.find('/', colon);
    port_ = std::stoi(address.substr(colon + 1, slash - colon - 1));
    base_ = address.substr(slash);
  }
  ~RunningStudio() {
    studio_.stop();
    thread_.join();
  }
  int port() const { return port_; }
  const std::string& base() const { return base_; }  // "/token/"
  std::string host() const { return "127.0.0.1:" + std::to_string(port_); }

 private:
  Studio studio_;
  std::thread thread_;
  int port_ = 0;
  std::string base_;
};

/// A connection on which anything can be said.
class Connection {
 public:
  explicit Connection(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(std::uint16_t(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;
    timeval patience{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  bool connected() const { return connected_; }

  /// Whether all of it could be sent.
  bool say(const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t n = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return false;
      sent += std::size_t(n);
    }
    return true;
  }
  /// One answer: its head and as much of a body as it announces.
  std::string hear() {
    std::string text;
    std::size_t wanted = std::string::npos;
    char piece[4096];
    while (text.size() < wanted) {
      const ssize_t n = recv(socket_, piece, sizeof piece, 0);
      if (n <= 0) break;
      text.append(piece, std::size_t(n));
      const std::size_t head = text.find("\r\n\r\n"), length = text.find("Content-Length: ");
      if (wanted != std::string::npos || head == std::string::npos) continue;
      wanted = head + 4 + (length < head ? std::stoul(text.substr(length + 16)) : 0);
    }
    return text;
  }

 private:
  int socket_;
  bool connected_ = false;
};

/// The status of an answer; 0 if there was none.
inline int status_of(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
}

inline std::string body_of(const std::string& answer) {
  const std::size_t head = answer.find("\r\n\r\n");
  return head == std::string::npos ? std::string() : answer.substr(head + 4);
}

/// What our own page would say.
inline std::string get_text(const RunningStudio& studio, const std::string& what) {
  return "GET " + studio.base() + what + " HTTP/1.1\r\nHost: " + studio.host() + "\r\n\r\n";
}
inline std::string post_text(const RunningStudio& studio, const std::string& what,
                             const std::string& body) {
  return "POST " + studio.base() + what + " HTTP/1.1\r\nHost: " + studio.host() +
         "\r\nOrigin: http://" + studio.host() +
         "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
         "\r\n\r\n" + body;
}

inline std::string answer_to(const RunningStudio& studio, const std::string& text) {
  Connection connection(studio.port());
  connection.say(text);
  return connection.hear();
}
inline std::string get(const RunningStudio& studio, const std::string& what) {
  return answer_to(studio, get_text(studio, what));
}
inline std::string post(const RunningStudio& studio, const std::string& what,
                        const std::string& body) {
  return answer_to(studio, post_text(studio, what, body));
}

}  // namespace hada
