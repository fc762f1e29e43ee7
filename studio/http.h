#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A server of HTTP/1.1 on this machine alone. What it does with threads, sockets and slow clients
/// is a module (`http_module.cpp`) that is loaded when a page is asked for, not with every start.
namespace hada {

struct HttpRequest {
  std::string method;
  std::string path;                            // decoded, without the query
  std::map<std::string, std::string> query;    // decoded
  std::map<std::string, std::string> headers;  // names in small letters; what is said twice is
                                               // joined by ", "
  std::string body;

  /// What a header says; empty if it is not there.
  std::string header(const std::string& name) const;
  /// What the query says of `name`, or `otherwise`.
  std::string word(const std::string& name, const std::string& otherwise = "") const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  /// If set: called for one piece after the other, which it may wait for; false ends the answer.
  std::function<bool(std::string& piece)> stream = {};
};

struct HttpHandlers {
  /// What is said before a body is read, if that ends it; the connection is closed then.
  std::function<std::optional<HttpResponse>(const HttpRequest&)> refuse;
  std::function<HttpResponse(const HttpRequest&)> answer;
};

struct HttpLimits {
  int connections = 64;  // served at a time
  int streams = 8;       // of them answers without end
  std::size_t body_bytes = std::size_t(4) << 20;
  std::size_t header_bytes = 32768;
  int request_seconds = 5;  // from its first byte to its last
  int answer_seconds = 60;  // to take a whole answer
  int idle_seconds = 5;     // between requests
};

class HttpServer {
 public:
  virtual ~HttpServer() = default;
  virtual int port() const = 0;
  /// Answers until `stop` is called, which any thread may do.
  virtual void serve() = 0;
  virtual void stop() = 0;
};

/// A server bound to 127.0.0.1.
///
/// port    0: any that is free
/// throws  Error if the port is taken, or the module is missing
std::unique_ptr<HttpServer> http_server(int port, HttpHandlers handlers,
                                        const HttpLimits& limits = {});

}  // namespace hada
