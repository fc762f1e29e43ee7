#include "studio/gate.h"

#include <algorithm>
#include <random>

#include "io/json.h"

namespace hada {
namespace {

bool is_here(const Gate& gate, const std::string& host) {
  const std::string port = ":" + std::to_string(gate.port);
  return host == "127.0.0.1" + port || host == "localhost" + port;
}

// Takes as long for every wrong token.
bool same(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= unsigned(a[i] ^ b[i]);
  return difference == 0;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 16 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string random_token() {
  std::random_device device;  // of the system, on Linux
  std::string token;
  for (int i = 0; i < 32; ++i) token += "0123456789abcdef"[device() % 16];
  return token;
}

std::optional<HttpResponse> refusal(const Gate& gate, const HttpRequest& request) {
  const bool posts = request.method == "POST";
  if (!posts && request.method != "GET") return told(405, "only GET and POST are answered");
  if (!is_here(gate, request.header("host"))) return told(403, "this server has another name");
  const std::string origin = request.header("origin");
  const bool ours = origin.starts_with("http://") && is_here(gate, origin.substr(7));
  if ((posts || !origin.empty()) && !ours) return told(403, "only our own page may ask");
  const std::string site = request.header("sec-fetch-site");
  if (!site.empty() && site != "same-origin" && site != "none") {
    return told(403, "only our own page may ask");
  }
  const std::size_t end = request.path.find('/', 1);
  if (end == std::string::npos || !same(request.path.substr(1, end - 1), gate.token)) {
    return told(404, "open the address that hada studio printed");
  }
  if (!request.header("range").empty()) return told(416, "answers are whole");
  if (!request.header("transfer-encoding").empty() || !request.header("content-encoding").empty()) {
    return told(411, "a body must be plain and say its length");
  }
  const std::string length = request.header("content-length");
  if (!length.empty() && !is_number(length)) return told(400, "the length is not a number");
  if (!posts) {
    if (!length.empty() && std::stoull(length) > 0) return told(400, "GET has no body");
    return std::nullopt;
  }
  if (length.empty()) return told(411, "a body must be plain and say its length");
  if (std::stoull(length) > gate.body_bytes) return told(413, "the body is too large");
  if (request.header("content-type") != "application/json") {
    return told(415, "the body must be application/json");
  }
  return std::nullopt;
}

std::string path_within(const Gate& gate, const HttpRequest& request) {
  return request.path.substr(gate.token.size() + 2);
}

HttpResponse guarded(HttpResponse answer) {
  for (const auto& [name, value] : {std::pair{"Content-Security-Policy",
                                              "default-src 'none'; script-src 'self'; style-src "
                                              "'self'; img-src 'self' blob: data:; connect-src "
                                              "'self'; base-uri 'none'; form-action 'none'; "
                                              "frame-ancestors 'none'"},
                                    {"X-Content-Type-Options", "nosniff"},
                                    {"Referrer-Policy", "no-referrer"},
                                    {"Cross-Origin-Resource-Policy", "same-origin"},
                                    {"Cross-Origin-Opener-Policy", "same-origin"},
                                    {"Cache-Control", "no-store"}}) {
    answer.headers.emplace_back(name, value);
  }
  return answer;
}

HttpResponse told(int status, const std::string& sentence) {
  return {.status = status, .body = Json{{"error", sentence}}.dump() + "\n"};
}

}  // namespace hada
