#include "studio/folder.h"

#include <algorithm>
#include <system_error>

#include "core/error.h"
#include "io/json.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

bool leads_into(const fs::path& folder, const fs::path& place) {
  const auto [end, ignored] =
      std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
  return end == folder.end();
}

}  // namespace

fs::path place_within(const fs::path& folder, const std::string& name) {
  const Error missing(name + ": there is no such thing in the folder of this studio");
  if (name.find('\0') != std::string::npos || name.size() > 1024) throw missing;
  const fs::path given(name);
  if (given.is_absolute()) throw missing;
  for (const fs::path& part : given) {
    if (part.native().starts_with(".")) throw missing;
  }
  std::error_code problem;
  const fs::path root = fs::canonical(folder, problem);
  if (problem) throw Error(folder.string() + ": no such folder; check the name");
  const fs::path place = fs::canonical(root / given, problem);
  // Where links lead is known only now.
  if (problem || !leads_into(root, place)) throw missing;
  return place;
}

std::string text_within(const fs::path& folder, const std::string& name) {
  const fs::path place = place_within(folder, name);
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) throw Error(name + ": is not a file; name a file");
  return text_of_file(place);
}

std::string without_folder(const fs::path& folder, std::string sentence) {
  for (const std::string& part : {folder.string() + "/", folder.string()}) {
    for (auto at = sentence.find(part); at != std::string::npos; at = sentence.find(part)) {
      sentence.erase(at, part.size());
    }
  }
  return sentence;
}

}  // namespace hada
