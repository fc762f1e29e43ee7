#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "studio/http.h"

namespace hada {

/// What may be asked of surfaces that lie in the folder: "api/surface/..." of docs/studio.md.
class SurfaceApi {
 public:
  explicit SurfaceApi(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  std::filesystem::path folder_;
  std::mutex busy_;  // one surface is in memory at a time
};

}  // namespace hada
