#pragma once

#include <filesystem>
#include <string>

#include "studio/http.h"
#include "studio/job.h"
#include "studio/scratch.h"

namespace hada {

/// Heavy work that is done in the background, one at a time: "api/job/..." of docs/studio.md.
class JobApi {
 public:
  /// program  that does the work: this one
  JobApi(std::filesystem::path folder, std::string program)
      : folder_(std::move(folder)), program_(std::move(program)) {}

  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  void start(const std::string& verb, const std::string& body);
  std::string state_text(const JobState& state) const;
  /// Where in `scratch_` a result lies; what an earlier job left there is removed.
  std::filesystem::path fresh_result(const std::string& name) const;

  std::filesystem::path folder_;
  std::string program_;
  Scratch scratch_;  // for results that a person has not given a name yet
  Job job_;
};

}  // namespace hada
