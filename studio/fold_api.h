#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "studio/fold_session.h"
#include "studio/http.h"

namespace hada {

/// The folded sheet of this studio, and what may be asked of it: "api/fold/..." of docs/studio.md.
class FoldApi {
 public:
  /// folder  where logs may be opened
  explicit FoldApi(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// throws  Error in one sentence if it cannot be done; then nothing has changed
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  std::string change(const std::string& verb, const std::string& body);
  HttpResponse exported(const std::string& format) const;

  std::filesystem::path folder_;
  std::mutex busy_;
  FoldSession session_;
};

}  // namespace hada
