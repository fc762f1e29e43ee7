#include <charconv>
#include <cstring>
#include <map>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/error.h"
#include "io/mesh_formats.h"

namespace hada {
namespace {

std::string_view next_word(std::string_view& line) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
  std::size_t end = 0;
  while (end < line.size() && !is_space(line[end])) ++end;
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

// The text of an OBJ on its way to a mesh; a vertex of the mesh is a pair of place and uv.
struct ObjReader {
  const std::string& name;
  int row = 0;
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::Vector2d> textures;
  std::map<std::pair<int, int>, int> vertices;
  TriangleMesh mesh;

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(name + ": line " + std::to_string(row) + ": " + what);
  }

  template <class Number>
  Number number(std::string_view word) const {
    Number value{};
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size()) {
      fail("'" + std::string(word.substr(0, 40)) + "' should be a number");
    }
    return value;
  }

  // Indices count from 1, or from the end where they are negative.
  int index(std::string_view word, std::size_t count) const {
    const long long given = number<int>(word);
    const long long at = given < 0 ? static_cast<long long>(count) + given : given - 1;
    if (at < 0 || at >= static_cast<long long>(count)) {
      fail("names number " + std::to_string(given) + " of " + std::to_string(count));
    }
    return int(at);
  }

  int corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    const int place = index(word.substr(0, slash), places.size());
    int texture = -1;
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1);
      const std::string_view second = rest.substr(0, rest.find('/'));
      if (!second.empty()) texture = index(second, textures.size());
    }
    const auto [entry, is_new] = vertices.try_emplace({place, texture}, int(vertices.size()));
    if (is_new) {
      mesh.vertices_mm.push_back(places[std::size_t(place)]);
      mesh.uv.push_back(texture < 0 ? Eigen::Vector2d::Zero() : textures[std::size_t(texture)]);
    }
    return entry->second;
  }

  void face(std::string_view line) {
    std::vector<int> corners;
    for (auto word = next_word(line); !word.empty(); word = next_word(line)) {
      corners.push_back(corner(word));
    }
    if (corners.size() < 3) fail("a face needs three corners");
    for (std::size_t k = 2; k < corners.size(); ++k) {
      mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }

  void read(std::string_view line) {
    const std::string_view kind = next_word(line);
    if (kind == "v") {
      Eigen::Vector3d place;
      for (double& x : place) x = number<double>(next_word(line));
      places.push_back(place);
    } else if (kind == "vt") {
      Eigen::Vector2d place;
      for (double& x : place) x = number<double>(next_word(line));
      textures.push_back(place);
    } else if (kind == "f") {
      face(line);
    }
  }
};

}  // namespace

TriangleMesh mesh_from_obj(std::string_view text, const std::string& name) {
  ObjReader reader{name, 0, {}, {}, {}, {}};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ++reader.row;
    reader.read(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (reader.textures.empty()) reader.mesh.uv.clear();
  return std::move(reader.mesh);
}

std::string obj_of(const TriangleMesh& mesh) {
  std::string text;
  for (const auto& v : mesh.vertices_mm) {
    text += fmt::format("v {} {} {}\n", float(v.x()), float(v.y()), float(v.z()));
  }
  for (const auto& t : mesh.uv) text += fmt::format("vt {} {}\n", float(t.x()), float(t.y()));
  for (const auto& [a, b, c] : mesh.triangles) {
    text += mesh.uv.empty() ? fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1)
                            : fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
  }
  return text;
}

std::string stl_of(const TriangleMesh& mesh) {
  constexpr std::size_t header = 80;
  std::string bytes(header, ' ');
  append(bytes, std::uint32_t(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](int k) { return mesh.vertices_mm[std::size_t(triangle[k])]; };
    const Eigen::Vector3d normal =
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
    for (const double x : normal) append(bytes, float(x));
    for (int k = 0; k < 3; ++k) {
      for (const double x : corner(k)) append(bytes, float(x));
    }
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

}  // namespace hada
