#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "app/measurement.h"
#include "studio/http.h"

namespace hada {

/// What may be asked of the spectrum of a surface: "api/spectrum/..." of docs/studio.md.
class SpectrumApi {
 public:
  explicit SpectrumApi(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  const Measurement& measured(const std::string& name);

  std::filesystem::path folder_;
  std::mutex busy_;  // one surface is measured at a time
  std::string name_;
  std::optional<Measurement> measured_;  // of the surface of that name, the last one
};

}  // namespace hada
