#include "io/fold_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "io/crease_lines.h"
#include "io/json.h"

namespace hada {
namespace {

constexpr std::size_t most_frames = 10000;

// A list of the file and how errors name it.
struct List {
  const Json& json;
  std::string where;

  [[noreturn]] void fail(std::size_t i, const std::string& what) const {
    throw Error(where + "[" + std::to_string(i) + "] " + what);
  }
};

const Json* find(const Json& frame, const std::string& key) {
  const auto found = frame.find(key);
  return found == frame.end() || found->is_null() ? nullptr : &*found;
}

// The list `key`, empty if it is absent; `count` entries unless that is 0 or nothing was given.
List list_of(const Json& frame, const std::string& key, std::size_t count,
             const std::string& where) {
  static const Json none = Json::array();
  const Json* json = find(frame, key);
  const std::string place = where + ": " + key;
  if (json == nullptr) return {none, place};
  if (!json->is_array()) throw Error(place + " must be a list in brackets [ ]");
  if (count > 0 && !json->empty() && json->size() != count) {
    throw Error(place + " has " + std::to_string(json->size()) + " entries where " +
                std::to_string(count) + " belong; make the lists agree");
  }
  return {*json, place};
}

double finite(const Json& json, const List& list, std::size_t i) {
  const double value = json.is_number() ? json.get<double>() : std::nan("");
  if (!std::isfinite(value)) list.fail(i, "must hold finite numbers");
  return value;
}

int index(const Json& json, std::size_t count, const List& list, std::size_t i) {
  if (!json.is_number_integer()) list.fail(i, "must hold whole numbers");
  const auto value = json.get<std::int64_t>();
  if (value < 0 || value >= std::int64_t(count)) {
    list.fail(i, "points to " + std::to_string(value) + ", but there are " + std::to_string(count));
  }
  return int(value);
}

std::string text_at(const Json& json, const std::string& key) {
  const Json* value = find(json, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : "";
}

void read_vertices(const Json& json, const std::string& where, FoldFrame& frame) {
  const List list = list_of(json, "vertices_coords", 0, where);
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    const Json& place = list.json[i];
    if (!place.is_array() || place.size() < 2 || place.size() > 3) {
      list.fail(i, "must be two or three numbers");
    }
    Eigen::Vector3d vertex = Eigen::Vector3d::Zero();
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      vertex[int(axis)] = finite(place[axis], list, i);
    }
    if (place.size() == 3) frame.flat = false;
    frame.vertices.push_back(vertex);
  }
}

void read_edges(const Json& json, const std::string& where, FoldFrame& frame) {
  const List list = list_of(json, "edges_vertices", 0, where);
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    const Json& ends = list.json[i];
    if (!ends.is_array() || ends.size() != 2) list.fail(i, "must be two vertices");
    const int from = index(ends[0], frame.vertices.size(), list, i);
    const int to = index(ends[1], frame.vertices.size(), list, i);
    if (from == to) list.fail(i, "begins and ends at one vertex");
    frame.edges.push_back({from, to});
  }
  const std::size_t count = frame.edges.size();
  const List letters = list_of(json, "edges_assignment", count, where);
  for (std::size_t i = 0; i < letters.json.size(); ++i) {
    const std::string letter =
        letters.json[i].is_string() ? letters.json[i].get<std::string>() : std::string();
    const char kind = letter.size() == 1 ? char(std::toupper(letter[0])) : '?';
    if (std::string("BMVFUCJ").find(kind) == std::string::npos) {
      letters.fail(i, "must be one of B, M, V, F, U, C, J");
    }
    frame.assignment.push_back(Crease(kind));
  }
  const List angles = list_of(json, "edges_foldAngle", count, where);
  for (std::size_t i = 0; i < angles.json.size(); ++i) {
    const bool silent = angles.json[i].is_null();
    const double angle = silent ? std::nan("") : finite(angles.json[i], angles, i);
    if (std::abs(angle) > 360.0) angles.fail(i, "must lie between -360 and 360 degrees");
    frame.fold_angle_deg.push_back(angle);
  }
}

void read_faces(const Json& json, const std::string& where, FoldFrame& frame) {
  const List list = list_of(json, "faces_vertices", 0, where);
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    if (!list.json[i].is_array() || list.json[i].size() < 3) {
      list.fail(i, "must be three vertices or more");
    }
    std::vector<int> face;
    for (const Json& vertex : list.json[i]) {
      face.push_back(index(vertex, frame.vertices.size(), list, i));
    }
    frame.faces.push_back(std::move(face));
  }
  const List orders = list_of(json, "faceOrders", 0, where);
  for (std::size_t i = 0; i < orders.json.size(); ++i) {
    const Json& order = orders.json[i];
    if (!order.is_array() || order.size() != 3) orders.fail(i, "must be two faces and an order");
    const double side = finite(order[2], orders, i);
    if (side != -1.0 && side != 0.0 && side != 1.0) orders.fail(i, "must end with -1, 0 or 1");
    const int face = index(order[0], frame.faces.size(), orders, i);
    const int other = index(order[1], frame.faces.size(), orders, i);
    if (face == other) orders.fail(i, "lays a face on itself");
    frame.face_orders.push_back({face, other, int(side)});
  }
}

FoldFrame frame_from(const Json& json, const std::string& where) {
  FoldFrame frame;
  frame.title = text_at(json, "frame_title");
  frame.unit = text_at(json, "frame_unit");
  if (const Json* classes = find(json, "frame_classes"); classes != nullptr) {
    if (!classes->is_array()) throw Error(where + ": frame_classes must be a list of words");
    for (const Json& word : *classes) {
      if (word.is_string()) frame.classes.push_back(word.get<std::string>());
    }
  }
  read_vertices(json, where, frame);
  read_edges(json, where, frame);
  read_faces(json, where, frame);
  return frame;
}

// A frame with what it inherits; `depth` counts the parents so far.
Json whole_frame(const Json& file, const Json& frames, std::size_t i, const std::string& where,
                 std::size_t depth = 0) {
  if (depth > frames.size()) throw Error(where + ": frames inherit in a circle; break it");
  if (i == 0) {
    Json key = file;
    key.erase("file_frames");
    return key;
  }
  const Json& frame = frames[i - 1];
  if (!frame.is_object()) throw Error(where + ": a frame must be an object in braces { }");
  const Json* inherits = find(frame, "frame_inherit");
  if (inherits == nullptr || !inherits->is_boolean() || !inherits->get<bool>()) return frame;
  const Json* parent = find(frame, "frame_parent");
  const List list{frames, where + ": file_frames"};
  const int from = parent == nullptr ? 0 : index(*parent, frames.size() + 1, list, i - 1);
  Json whole = whole_frame(file, frames, std::size_t(from), where, depth + 1);
  for (const auto& [key, value] : frame.items()) whole[key] = value;
  return whole;
}

void put_frame(Json& json, const FoldFrame& frame) {
  if (!frame.title.empty()) json["frame_title"] = frame.title;
  if (!frame.classes.empty()) json["frame_classes"] = frame.classes;
  json["frame_attributes"] = Json::array({frame.flat ? "2D" : "3D"});
  if (!frame.unit.empty()) json["frame_unit"] = frame.unit;
  Json& vertices = json["vertices_coords"] = Json::array();
  for (const auto& v : frame.vertices) {
    vertices.push_back(frame.flat ? Json{v.x(), v.y()} : Json{v.x(), v.y(), v.z()});
  }
  json["edges_vertices"] = frame.edges;
  if (!frame.assignment.empty()) {
    Json& letters = json["edges_assignment"] = Json::array();
    for (const Crease crease : frame.assignment) letters.push_back(std::string(1, char(crease)));
  }
  if (!frame.fold_angle_deg.empty()) {
    Json& angles = json["edges_foldAngle"] = Json::array();
    for (const double angle : frame.fold_angle_deg) {
      angles.push_back(std::isfinite(angle) ? Json(angle) : Json());
    }
  }
  json["faces_vertices"] = frame.faces;
  if (!frame.face_orders.empty()) {
    Json& orders = json["faceOrders"] = Json::array();
    for (const FaceOrder& o : frame.face_orders) orders.push_back({o.face, o.other, o.order});
  }
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending;
}

}  // namespace

FoldFile read_fold(const std::filesystem::path& path) {
  const std::string where = path.string();
  const Json json = read_plain_json(path);
  if (!json.is_object()) throw Error(where + ": is no FOLD file; it must be an object { }");
  static const Json none = Json::array();
  const Json* frames = find(json, "file_frames");
  if (frames != nullptr && (!frames->is_array() || frames->size() > most_frames)) {
    throw Error(where + ": file_frames must be a list of at most " + std::to_string(most_frames) +
                " frames");
  }
  const Json& others = frames == nullptr ? none : *frames;
  FoldFile file;
  file.creator = text_at(json, "file_creator");
  file.author = text_at(json, "file_author");
  file.title = text_at(json, "file_title");
  for (std::size_t i = 0; i <= others.size(); ++i) {
    const std::string place =
        i == 0 ? where : where + ": file_frames[" + std::to_string(i - 1) + "]";
    file.frames.push_back(frame_from(whole_frame(json, others, i, where), place));
  }
  return file;
}

std::string fold_text(const FoldFile& file) {
  Json json = Json::object();
  json["file_spec"] = 1.2;
  json["file_creator"] = file.creator.empty() ? "hada" : file.creator;
  if (!file.author.empty()) json["file_author"] = file.author;
  if (!file.title.empty()) json["file_title"] = file.title;
  json["file_classes"] = Json::array({file.frames.size() > 1 ? "animation" : "singleModel"});
  for (std::size_t i = 0; i < file.frames.size(); ++i) {
    if (i == 0) {
      put_frame(json, file.frames[0]);
      continue;
    }
    Json frame = Json::object();
    put_frame(frame, file.frames[i]);
    json["file_frames"].push_back(std::move(frame));
  }
  return json.dump() + "\n";
}

FoldFile read_crease_pattern(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".fold") return read_fold(path);
  if (ending != ".cp" && ending != ".opx" && ending != ".svg") {
    throw Error(path.string() +
                ": is no crease pattern by its name; give .fold, .cp, .opx or .svg");
  }
  const std::string text = text_of_file(path);
  const std::string where = path.string();
  FoldFile file;
  file.title = path.stem().string();
  file.frames.push_back(ending == ".cp"    ? lines_of_cp(text, where)
                        : ending == ".opx" ? lines_of_opx(text, where)
                                           : lines_of_svg(text, where));
  file.frames[0].classes = {"creasePattern"};
  return file;
}

}  // namespace hada
