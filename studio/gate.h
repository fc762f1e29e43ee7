#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "studio/http.h"

namespace hada {

/// Who may ask: those who know the token, from a page of ours, on this machine.
struct Gate {
  int port = 0;
  std::string token;
  std::size_t body_bytes = 0;
};

/// 128 random bits of the system as 32 hexadecimal digits.
std::string random_token();

/// Why a request is not answered, judged by its head alone; none if it may pass.
///
/// Host must name this server, or a name that an attacker made to point here would pass (DNS
/// rebinding). Origin, where a browser sends one, must be our own page; whatever changes something
/// must send it (cross-site requests). The path must begin with the token. A body must say its
/// length beforehand, be JSON and not packed.
std::optional<HttpResponse> refusal(const Gate& gate, const HttpRequest& request);

/// The path behind the token: "api/fold/state"; empty for the page itself.
std::string path_within(const Gate& gate, const HttpRequest& request);

/// `answer` with headers that allow a browser nothing but what comes from here.
HttpResponse guarded(HttpResponse answer);

/// An answer that says in one sentence why there is no other.
HttpResponse told(int status, const std::string& sentence);

}  // namespace hada
