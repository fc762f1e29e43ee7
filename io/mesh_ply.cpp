#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include "core/error.h"
#include "io/mesh_formats.h"

namespace hada {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<Type> type_named(std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (word == names[k][0] || word == names[k][1]) return Type(k);
  }
  return std::nullopt;
}

struct Property {
  std::string name;
  Type type = Type::f32;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

// What stands behind the header: words of text, or numbers in either order of bytes.
struct PlyReader {
  std::string_view rest;
  const std::string& name;
  bool ascii = false, swapped = false;

  [[noreturn]] void fail(const std::string& what) const { throw Error(name + ": " + what); }

  std::string_view line() {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) fail("ends within its header; copy the file again");
    std::string_view text = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  double word() {
    const std::size_t begin = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
    rest.remove_prefix(begin);
    const std::string_view text = rest.substr(0, rest.find_first_of(" \t\r\n"));
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty()) fail("ends early; copy the file again");
    if (problem != std::errc{} || end != text.data() + text.size()) {
      fail("'" + std::string(text.substr(0, 40)) + "' should be a number");
    }
    rest.remove_prefix(text.size());
    return value;
  }

  template <class Value>
  double bytes() {
    if (rest.size() < sizeof(Value)) fail("ends early; copy the file again");
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), rest.data(), raw.size());
    if (swapped) std::reverse(raw.begin(), raw.end());
    rest.remove_prefix(raw.size());
    return double(std::bit_cast<Value>(raw));
  }

  double value(Type type) {
    if (ascii) return word();
    switch (type) {
      case Type::i8:
        return bytes<std::int8_t>();
      case Type::u8:
        return bytes<std::uint8_t>();
      case Type::i16:
        return bytes<std::int16_t>();
      case Type::u16:
        return bytes<std::uint16_t>();
      case Type::i32:
        return bytes<std::int32_t>();
      case Type::u32:
        return bytes<std::uint32_t>();
      case Type::f32:
        return bytes<float>();
      default:
        return bytes<double>();
    }
  }

  int whole(Type type) {
    const double number = value(type);
    if (!(std::abs(number) <= std::numeric_limits<int>::max()) || number != std::floor(number)) {
      fail("a face has a corner or a count that is no whole number");
    }
    return int(number);
  }
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find_first_of(" \t")));
    text.remove_prefix(words.back().size());
  }
}

std::vector<Element> header_of(PlyReader& reader) {
  std::vector<Element> elements;
  if (reader.line() != "ply") reader.fail("is no PLY file: its first line must be 'ply'");
  for (;;) {
    const std::string_view line = reader.line();
    const auto words = words_of(line);
    const auto bad = [&] { reader.fail("header: '" + std::string(line.substr(0, 60)) + "'?"); };
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") return elements;
    if (words[0] == "format" && words.size() == 3) {
      reader.ascii = words[1] == "ascii";
      reader.swapped = words[1] == "binary_big_endian";
      if (!reader.ascii && !reader.swapped && words[1] != "binary_little_endian") bad();
    } else if (words[0] == "element" && words.size() == 3) {
      Element element{std::string(words[1]), 0, {}};
      const auto [end, problem] =
          std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
      if (problem != std::errc{} || end != words[2].data() + words[2].size()) bad();
      // An item without properties takes no bytes, and a count of them no end.
      elements.push_back(element);
    } else if (words[0] == "property" && !elements.empty() &&
               (words.size() == 3 || (words.size() == 5 && words[1] == "list"))) {
      const auto type = type_named(words[words.size() - 2]);
      const auto count = words.size() == 5 ? type_named(words[2]) : std::optional<Type>{};
      if (!type || (words.size() == 5 && !count)) bad();
      elements.back().properties.push_back({std::string(words.back()), *type, count});
    } else {
      bad();
    }
  }
}

void read_vertex(PlyReader& reader, const Element& element, TriangleMesh& mesh) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  bool has_uv = false;
  for (const Property& property : element.properties) {
    if (property.count) {
      for (int left = reader.whole(*property.count); left > 0; --left) reader.value(property.type);
      continue;
    }
    const double value = reader.value(property.type);
    const std::string& name = property.name;
    if (name == "x" || name == "y" || name == "z") place[name[0] - 'x'] = value;
    const bool u = name == "u" || name == "s" || name == "texture_u";
    const bool v = name == "v" || name == "t" || name == "texture_v";
    if (u || v) uv[v ? 1 : 0] = value;
    has_uv = has_uv || u || v;
  }
  mesh.vertices_mm.push_back(place);
  if (has_uv) mesh.uv.push_back(uv);
}

void read_face(PlyReader& reader, const Element& element, TriangleMesh& mesh) {
  for (const Property& property : element.properties) {
    const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
    const int count = property.count ? reader.whole(*property.count) : 1;
    int first = 0, before = 0;
    for (int k = 0; k < count; ++k) {
      if (!corners) {
        reader.value(property.type);
        continue;
      }
      const int at = reader.whole(property.type);
      if (k == 0) first = at;
      if (k >= 2) mesh.triangles.push_back({first, before, at});
      before = at;
    }
  }
}

}  // namespace

TriangleMesh mesh_from_ply(std::string_view bytes, const std::string& name) {
  PlyReader reader{bytes, name};
  TriangleMesh mesh;
  for (const Element& element : header_of(reader)) {
    if (element.properties.empty()) continue;
    for (std::uint64_t k = 0; k < element.count; ++k) {
      if (element.name == "face") {
        read_face(reader, element, mesh);
      } else if (element.name == "vertex") {
        read_vertex(reader, element, mesh);
      } else {
        TriangleMesh ignored;
        read_vertex(reader, element, ignored);
      }
    }
  }
  return mesh;
}

std::string ply_of(const TriangleMesh& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.vertices_mm.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!mesh.uv.empty()) bytes += "property float s\nproperty float t\n";
  bytes += "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t k = 0; k < mesh.vertices_mm.size(); ++k) {
    for (const double x : mesh.vertices_mm[k]) append(bytes, float(x));
    if (mesh.uv.empty()) continue;
    for (const double x : mesh.uv[k]) append(bytes, float(x));
  }
  for (const auto& triangle : mesh.triangles) {
    append(bytes, std::uint8_t(3));
    for (const int corner : triangle) append(bytes, std::int32_t(corner));
  }
  return bytes;
}

}  // namespace hada
