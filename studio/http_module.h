#pragma once

#include "studio/http.h"

namespace hada {

/// What the module with the HTTP library inside offers to `http.cpp`, and to nobody else.
struct HttpModule {
  /// Null if the port cannot be bound.
  HttpServer* (*make)(int port, HttpHandlers&& handlers, const HttpLimits& limits) noexcept;
};

/// The name under which the module exports its HttpModule.
inline constexpr const char* http_module_symbol = "hada_http_module";

}  // namespace hada
