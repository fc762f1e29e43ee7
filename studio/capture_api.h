#pragma once

#include <filesystem>
#include <string>

#include "studio/http.h"
#include "studio/job.h"
#include "studio/scratch.h"

namespace hada {

/// What may be asked of captures, and the work on them: "api/capture/..." and "api/job/..." of
/// docs/studio.md.
class CaptureApi {
 public:
  /// program  that does the work: this one
  CaptureApi(std::filesystem::path folder, std::string program)
      : folder_(std::move(folder)), program_(std::move(program)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse capture(const std::string& verb, const HttpRequest& request) const;
  HttpResponse job(const std::string& verb, const HttpRequest& request);

 private:
  HttpResponse started(const std::string& verb, const std::string& body);
  std::string state_text(const JobState& state) const;

  std::filesystem::path folder_;
  std::string program_;
  Scratch scratch_;  // for the lights that were read off spheres
  Job job_;
};

}  // namespace hada
