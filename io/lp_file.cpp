#include "io/lp_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/error.h"

namespace hada {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || std::filesystem::is_directory(path)) {
    throw Error(path.string() + ": cannot be read; give the name of a light-position file");
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

// Takes the last word off `text`.
std::string_view last_word(std::string_view& text) {
  text = trimmed(text);
  std::size_t begin = text.size();
  while (begin > 0 && !is_space(text[begin - 1])) --begin;
  const std::string_view word = text.substr(begin);
  text = trimmed(text.substr(0, begin));
  return word;
}

template <class Number>
std::optional<Number> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string counted(std::size_t count, const std::string& of_one, const std::string& of_many) {
  return std::to_string(count) + (count == 1 ? of_one : of_many);
}

// The light of one line, `name x y z`.
Light light_from(std::string_view line, const std::string& where) {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  bool good = true;
  for (int axis = 2; axis >= 0; --axis) {
    const auto value = number<double>(last_word(line));
    good = good && value && std::isfinite(*value);
    if (good) way[axis] = *value;
  }
  if (!good || line.empty()) {
    throw Error(where + ": must be the name of a picture and three finite numbers, x y z");
  }
  const double length = way.stableNorm();  // the squares of tiny or huge numbers would vanish
  if (!(length > 0.0)) {
    throw Error(where + ": its direction has no length; give the way from the sample to the light");
  }
  Light light;
  light.image = line.substr(line.find_last_of("/\\") + 1);
  if (light.image.empty()) throw Error(where + ": names a folder; name the picture in it");
  light.direction = (way / length).normalized();
  return light;
}

}  // namespace

std::vector<Light> read_lp(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::istringstream stream(text_of(path));
  std::optional<std::size_t> announced;
  std::vector<Light> lights;
  std::string text;
  for (int row = 1; std::getline(stream, text); ++row) {
    const std::string_view line = trimmed(text);
    if (line.empty()) continue;
    const std::string where = name + ": line " + std::to_string(row);
    if (announced) {
      lights.push_back(light_from(line, where));
      continue;
    }
    announced = number<std::size_t>(line);
    if (!announced || *announced == 0) {
      throw Error(where + ": must be the number of lights; a line `name x y z` for each follows");
    }
  }
  if (!announced) {
    throw Error(name + ": is empty; begin it with the number of lights");
  }
  if (lights.size() != *announced) {
    throw Error(name + ": " + counted(*announced, " light is", " lights are") + " announced, but " +
                counted(lights.size(), " follows", " follow") + "; correct the first line");
  }
  const bool all_below = std::all_of(lights.begin(), lights.end(),
                                     [](const Light& light) { return light.direction.z() <= 0.0; });
  if (all_below) {
    throw Error(name + ": no light stands above the table; z must point to the camera");
  }
  return lights;
}

std::string lp_text(const std::vector<Light>& lights) {
  std::string text = std::to_string(lights.size()) + "\n";
  for (const Light& light : lights) {
    std::array<char, 64> way{};
    std::snprintf(way.data(), way.size(), " %.10f %.10f %.10f\n", light.direction.x(),
                  light.direction.y(), light.direction.z());
    text += light.image + way.data();
  }
  return text;
}

bool is_lp(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".lp";
}

}  // namespace hada
