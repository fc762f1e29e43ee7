#pragma once

#include <filesystem>
#include <string>

#include "studio/http.h"

namespace hada {

/// What may be asked of captures: "api/capture/..." of docs/studio.md.
class CaptureApi {
 public:
  explicit CaptureApi(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace hada
