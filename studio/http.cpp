#include "studio/http.h"

#include <array>
#include <filesystem>
#include <system_error>

#include <dlfcn.h>

#include "core/error.h"
#include "studio/http_module.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

// Beside the program, where it is installed, where it was built.
const HttpModule& load_module() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array<fs::path, 3> places{folder / "hada_http.so", folder / "../lib/hada/hada_http.so",
                                       HADA_HTTP_MODULE};
  for (const auto& place : places) {
    if (!fs::exists(place, ignored)) continue;
    void* const library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = library ? dlsym(library, http_module_symbol) : nullptr;
    if (symbol) return *static_cast<const HttpModule*>(symbol);
    throw Error(place.string() + ": the web server cannot be loaded (" + dlerror() +
                "); install hada and cpp-httplib again");
  }
  throw Error("hada_http.so: the web server is missing; put it beside the program");
}

}  // namespace

std::string HttpRequest::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string() : found->second;
}

std::string HttpRequest::word(const std::string& name, const std::string& otherwise) const {
  const auto found = query.find(name);
  return found == query.end() ? otherwise : found->second;
}

std::unique_ptr<HttpServer> http_server(int port, HttpHandlers handlers, const HttpLimits& limits) {
  static const HttpModule& module = load_module();
  std::unique_ptr<HttpServer> server(module.make(port, std::move(handlers), limits));
  if (!server) {
    throw Error("127.0.0.1:" + std::to_string(port) +
                ": is taken by another program; choose another --port");
  }
  return server;
}

}  // namespace hada
