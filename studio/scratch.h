#pragma once

#include <filesystem>
#include <string>

#include "studio/http.h"

namespace hada {

/// A folder for files on their way to the browser, removed with its contents.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A file that the browser saves; of its name only plain letters, digits, '.', '-' and '_' are
/// kept.
HttpResponse download(const std::string& name, std::string bytes);

}  // namespace hada
