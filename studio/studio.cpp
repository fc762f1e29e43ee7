#include "studio/studio.h"

#include <algorithm>

#include "core/error.h"
#include "studio/capture_api.h"
#include "studio/fold_api.h"
#include "studio/gate.h"
#include "studio/http.h"
#include "studio/job_api.h"
#include "studio/material_api.h"
#include "studio/page.h"
#include "studio/solid_api.h"
#include "studio/spectrum_api.h"
#include "studio/surface_api.h"

namespace hada {

struct Studio::Inside {
  Inside(const std::filesystem::path& folder, const std::string& program)
      : fold(folder),
        material(folder),
        surface(folder),
        spectrum(folder),
        capture(folder),
        job(folder, program) {}

  HttpResponse answer(const HttpRequest& request) {
    std::string path = path_within(gate, request);
    if (path.empty()) path = "index.html";
    if (path.starts_with("api/")) return api(path.substr(4), request);
    for (const PageFile& file : page_files()) {
      if (file.name == path) {
        return {.type = std::string(type_of(path)), .body = std::string(file.bytes)};
      }
    }
    return told(404, "there is no such page");
  }

  HttpResponse api(const std::string& path, const HttpRequest& request) try {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string room = path.substr(0, slash),
                      verb = path.substr(std::min(slash + 1, path.size()));
    if (room == "fold") return fold.answer(verb, request);
    if (room == "material") return material.answer(verb, request);
    if (room == "solid") return solid.answer(verb, request);
    if (room == "surface") return surface.answer(verb, request);
    if (room == "spectrum") return spectrum.answer(verb, request);
    if (room == "capture") return capture.answer(verb, request);
    if (room == "job") return job.answer(verb, request);
    return told(404, "there is no such request");
  } catch (const Error& error) {
    return told(422, error.what());
  } catch (const std::exception&) {
    return told(500, "something unforeseen went wrong; please report what you did");
  }

  Gate gate;
  FoldApi fold;
  MaterialApi material;
  SolidApi solid;
  SurfaceApi surface;
  SpectrumApi spectrum;
  CaptureApi capture;
  JobApi job;
  std::unique_ptr<HttpServer> server;
};

Studio::Studio(const StudioArguments& arguments) {
  if (!std::filesystem::is_directory(arguments.folder)) {
    throw Error(arguments.folder.string() + ": no such folder; check the name");
  }
  inside_ =
      std::make_unique<Inside>(std::filesystem::canonical(arguments.folder), arguments.program);
  Inside& inside = *inside_;
  const HttpLimits limits;
  inside.server = http_server(
      arguments.port,
      {[&inside](const HttpRequest& request) {
         auto refused = refusal(inside.gate, request);
         return refused ? std::optional(guarded(*std::move(refused))) : std::nullopt;
       },
       [&inside](const HttpRequest& request) { return guarded(inside.answer(request)); }},
      limits);
  inside.gate = {inside.server->port(), random_token(), limits.body_bytes};
}

Studio::~Studio() = default;

std::string Studio::address() const {
  const Gate& gate = inside_->gate;
  return "http://127.0.0.1:" + std::to_string(gate.port) + "/" + gate.token + "/";
}

void Studio::serve() {
  inside_->server->serve();
}

void Studio::stop() {
  inside_->server->stop();
}

}  // namespace hada
