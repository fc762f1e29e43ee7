#include "studio/scratch.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include <stdlib.h>

#include "core/error.h"

namespace hada {

Scratch::Scratch() {
  std::string pattern = (std::filesystem::temp_directory_path() / "hada-studio-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw Error(pattern + ": no folder can be made there");
  path_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

HttpResponse download(const std::string& name, std::string bytes) {
  std::string plain;
  for (const char c : name) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-';
    plain += kept ? c : '_';
  }
  return {.type = "application/octet-stream",
          .body = std::move(bytes),
          .headers = {{"Content-Disposition", "attachment; filename=\"" + plain + "\""}}};
}

}  // namespace hada
