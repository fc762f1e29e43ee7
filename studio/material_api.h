#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "core/random.h"
#include "core/surface.h"
#include "studio/http.h"
#include "synth/forged.h"
#include "synth/material.h"

namespace hada {

/// What may be asked of materials: "api/material/..." of docs/studio.md.
class MaterialApi {
 public:
  explicit MaterialApi(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  Surface made(const Material& material, const Extent& extent, Seed seed);

  /// What decides how a block of steel looks before it is etched.
  struct Forging {
    std::string sequence, kernel;
    int rows = 0, cols = 0;
    Seed seed = 0;
    bool operator==(const Forging&) const = default;
  };

  std::filesystem::path folder_;
  std::mutex busy_;  // one surface is made at a time
  Forging forging_;  // of `forged_`, the last one
  ForgedPart forged_;
};

}  // namespace hada
