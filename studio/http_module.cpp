#include "studio/http_module.h"

#include <algorithm>
#include <atomic>
#include <cctype>

#include <httplib.h>

#include "studio/deadline_stream.h"

namespace hada {
namespace {

using namespace std::chrono_literals;

// The library's view of our stream.
class SocketStream : public httplib::Stream {
 public:
  explicit SocketStream(socket_t socket) : stream_(socket), socket_(socket) {}
  DeadlineStream& deadline() { return stream_; }

  bool is_readable() const override { return stream_.wait(0ms); }
  bool is_writable() const override { return true; }
  ssize_t read(char* to, size_t size) override { return stream_.read(to, size); }
  ssize_t write(const char* from, size_t size) override { return stream_.write(from, size); }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip = "127.0.0.1";
    port = 0;
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    get_remote_ip_and_port(ip, port);
  }
  socket_t socket() const override { return socket_; }

 private:
  DeadlineStream stream_;
  socket_t socket_;
};

// What the thread of a connection must know of the request that it is answering.
struct Answering {
  DeadlineStream* stream = nullptr;
  bool refused = false;
};
thread_local Answering answering;

HttpRequest request_of(const httplib::Request& from) {
  HttpRequest request{from.method, from.path, {}, {}, from.body};
  for (const auto& [name, value] : from.params) request.query[name] = value;
  for (const auto& [name, value] : from.headers) {
    std::string key = name;
    std::transform(key.begin(), key.end(), key.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    std::string& text = request.headers[key];
    text += (text.empty() ? "" : ", ") + value;
  }
  return request;
}

// On the way to the same machine compression only costs time: seconds for the scripts of the page.
void uncompressed(httplib::Request& request) {
  request.headers.erase("Accept-Encoding");
}

class Server : public HttpServer, private httplib::Server {
 public:
  Server(HttpHandlers&& handlers, const HttpLimits& limits)
      : handlers_(std::move(handlers)), limits_(limits) {
    new_task_queue = [threads = limits.connections] {
      return new httplib::ThreadPool(std::size_t(threads));
    };
    set_payload_max_length(limits.body_bytes);
    set_tcp_nodelay(true);
    set_keep_alive_max_count(100000);
    set_keep_alive_timeout(limits.idle_seconds);
    set_pre_routing_handler([this](const httplib::Request& from, httplib::Response& to) {
      const auto refusal = handlers_.refuse(request_of(from));
      if (!refusal) return HandlerResponse::Unhandled;
      answering.refused = true;
      put(*refusal, to);
      return HandlerResponse::Handled;
    });
    const auto answer = [this](const httplib::Request& from, httplib::Response& to) {
      put(handlers_.answer(request_of(from)), to);
    };
    Get(".*", answer);
    Post(".*", answer);
  }

  bool bind(int port) {
    port_ = port > 0 ? (bind_to_port("127.0.0.1", port) ? port : 0)
                     : std::max(0, bind_to_any_port("127.0.0.1"));
    return port_ > 0;
  }
  int port() const override { return port_; }
  void serve() override { listen_after_bind(); }
  void stop() override { httplib::Server::stop(); }

 private:
  void put(const HttpResponse& from, httplib::Response& to) {
    to.status = from.status;
    for (const auto& [name, value] : from.headers) to.set_header(name, value);
    answering.stream->allow_answer(std::chrono::seconds(limits_.answer_seconds));
    if (!from.stream) {
      to.set_content(from.body, from.type);
      return;
    }
    if (++streams_ > limits_.streams) {
      --streams_;
      to.status = 503;
      to.set_content("too many pages listen; close some of them\n", "text/plain");
      return;
    }
    answering.stream->allow_endless_answer();
    to.set_chunked_content_provider(
        from.type,
        [this, stream = from.stream](std::size_t, httplib::DataSink& sink) {
          std::string piece;
          const bool more = stream(piece);
          if (!piece.empty() && !sink.write(piece.data(), piece.size())) return false;
          if (!more || svr_sock_ == INVALID_SOCKET) sink.done();
          return true;
        },
        [this](bool) { --streams_; });
  }

  // In place of the library's own, whose clients may take as long as they like.
  bool process_and_close_socket(socket_t socket) override {
    SocketStream stream(socket);
    answering = {&stream.deadline(), false};
    while (next_request(stream.deadline())) {
      stream.deadline().expect(limits_.header_bytes + limits_.body_bytes,
                               std::chrono::seconds(limits_.request_seconds));
      stream.deadline().allow_answer(std::chrono::seconds(limits_.answer_seconds));
      bool closed = false;
      if (!process_request(stream, false, closed, uncompressed) || closed) break;
      if (answering.refused || stream.deadline().is_broken()) break;
    }
    // What a refused client still sends is taken off, or it would never read why.
    ::shutdown(socket, SHUT_WR);
    stream.deadline().expect(limits_.body_bytes, 1s);
    char rest[4096];
    while (answering.refused && stream.read(rest, sizeof rest) > 0) continue;
    ::close(socket);
    return true;
  }

  bool next_request(const DeadlineStream& stream) const {
    for (int i = 0; i < 10 * limits_.idle_seconds && svr_sock_ != INVALID_SOCKET; ++i) {
      if (stream.wait(100ms)) return true;
    }
    return false;
  }

  HttpHandlers handlers_;
  HttpLimits limits_;
  std::atomic<int> streams_ = 0;
  int port_ = 0;
};

HttpServer* make(int port, HttpHandlers&& handlers, const HttpLimits& limits) noexcept try {
  auto server = std::make_unique<Server>(std::move(handlers), limits);
  return server->bind(port) ? server.release() : nullptr;
} catch (const std::exception&) {
  return nullptr;
}

}  // namespace
}  // namespace hada

extern "C" __attribute__((visibility("default")))
const hada::HttpModule hada_http_module = {hada::make};
