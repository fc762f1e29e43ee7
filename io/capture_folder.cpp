#include "io/capture_folder.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "io/image_file.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool is_letter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

// The runs of letters of a name without its ending, in lower case: "Buddha.Mask.tga" has buddha,
// mask.
std::set<std::string> words_of(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  for (const char c : fs::path(name).stem().string() + " ") {
    if (is_letter(c)) {
      word += lower(c);
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

// Maps that others computed from photographs often lie beside them.
bool is_result(const std::set<std::string>& words) {
  static constexpr std::array<const char*, 8> results = {"albedo", "normal", "normals", "depth",
                                                         "depths", "height", "heights", "preview"};
  return std::any_of(results.begin(), results.end(),
                     [&](const char* word) { return words.contains(word); });
}

constexpr std::array<const char*, 4> roles = {"mask", "ambient", "flat", "dark"};

// The role that a word of the name states; "(mask)" where mask is only a part of a word, which may
// be mymask.png or the first of a series damask_1.png, damask_2.png, ...
std::string role_of(const std::string& name) {
  const auto words = words_of(name);
  for (const char* role : roles) {
    if (words.contains(role)) return role;
  }
  const bool within = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.find("mask") != std::string::npos;
  });
  return within ? "(mask)" : "";
}

std::vector<std::string> files_of(const fs::path& folder, std::vector<std::string>& left_out) {
  std::error_code problem;
  if (!fs::exists(folder, problem)) {
    throw Error(folder.string() + ": no such folder; check the name");
  }
  if (!fs::is_directory(folder, problem)) {
    throw Error(folder.string() + ": is not a folder; name the folder that holds the pictures");
  }
  std::vector<std::string> names;
  for (const auto& item : fs::directory_iterator(folder, problem)) {
    const std::string name = item.path().filename().string();
    if (name.front() == '.' || name == "capture.json") continue;
    std::error_code ignored;
    if (item.is_regular_file(ignored))
      names.push_back(name);
    else
      left_out.push_back(name + " (not a file)");
  }
  if (problem) {
    throw Error(folder.string() + ": cannot be listed (" + problem.message() +
                "); check its rights");
  }
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

// The run of digits at `start` without its leading zeros, and where it ends.
struct Number {
  std::string_view digits;
  std::size_t end;
};

Number number_at(const std::string& text, std::size_t start) {
  std::size_t end = start;
  while (end < text.size() && is_digit(text[end])) ++end;
  while (start < end && text[start] == '0') ++start;
  return {std::string_view(text).substr(start, end - start), end};
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const Number left = number_at(a, i);
      const Number right = number_at(b, j);
      if (left.digits.size() != right.digits.size()) {
        return left.digits.size() < right.digits.size();
      }
      if (left.digits != right.digits) return left.digits < right.digits;
      i = left.end;
      j = right.end;
    } else {
      if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
      ++i;
      ++j;
    }
  }
  const std::size_t rest_a = a.size() - i;
  const std::size_t rest_b = b.size() - j;
  return rest_a != rest_b ? rest_a < rest_b : a < b;  // a01 and a1: any order, but always the same
}

CaptureFolder sorted_folder(const fs::path& folder) {
  CaptureFolder sorted;
  std::map<std::string, std::vector<std::string>> candidates;  // by role
  for (const auto& name : files_of(folder, sorted.left_out)) {
    const std::string role = role_of(name);
    if (!has_image_name(name))
      sorted.left_out.push_back(name + " (not an image)");
    else if (!role.empty())
      candidates[role].push_back(name);
    else if (is_result(words_of(name)))
      sorted.left_out.push_back(name + " (not a photograph)");
    else
      sorted.pictures.push_back(name);
  }
  if (candidates["(mask)"].size() == 1 && candidates["mask"].empty()) {
    candidates["mask"] = candidates["(mask)"];
    candidates.erase("(mask)");
  }
  const bool others = !sorted.pictures.empty();
  for (const auto& [role, names] : candidates) {
    if (role != "(mask)" && (names.size() == 1 || (role == "mask" && others && !names.empty()))) {
      sorted.auxiliary[role] = names.front();
      for (std::size_t i = 1; i < names.size(); ++i) {
        sorted.left_out.push_back(names[i] + " (another mask)");
      }
    } else {  // dark_1, dark_2, ...: a series of photographs of something dark
      sorted.pictures.insert(sorted.pictures.end(), names.begin(), names.end());
    }
  }
  std::sort(sorted.pictures.begin(), sorted.pictures.end(), natural_less);
  std::sort(sorted.left_out.begin(), sorted.left_out.end(), natural_less);
  return sorted;
}

}  // namespace hada
