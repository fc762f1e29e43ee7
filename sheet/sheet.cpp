#include "sheet/sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.h"
#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector2d;

double area_of(const std::vector<int>& face, const std::vector<Eigen::Vector3d>& vertices) {
  double twice = 0.0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto& a = vertices[std::size_t(face[i])];
    const auto& b = vertices[std::size_t(face[(i + 1) % face.size()])];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double default_angle(Crease crease) {
  if (crease == Crease::valley) return std::numbers::pi;
  return crease == Crease::mountain ? -std::numbers::pi : 0.0;
}

// A segment of a fold that parts no faces; -1 if there is none.
int loose_end(const FoldFrame& frame, const Arrangement& cut) {
  for (std::size_t line = 0; line < frame.edges.size(); ++line) {
    if (!is_folded(frame.crease(int(line)))) continue;
    for (const int s : cut.segments_of[line]) {
      const auto [left, right] = cut.cells_of[std::size_t(s)];
      if (left == right) return s;
    }
  }
  return -1;
}

// The lines cut at their crossings. Drawn lines miss each other by what the hand did not see, so
// the snap distance grows until no fold ends loosely.
Arrangement drawn_lines(const FoldFrame& frame, const std::string& where) {
  std::vector<Vector2d> places;
  for (const auto& vertex : frame.vertices) places.push_back(vertex.head<2>());
  const double first = snap_distance(places, frame.edges), most = 0.005 * size_of(places);
  Arrangement cut = arrangement(places, frame.edges, first);
  const int loose = loose_end(frame, cut);
  if (loose < 0) return cut;
  for (double snap = std::max(2.0 * first, 1e-6 * most); snap < most; snap *= 2.0) {
    Arrangement wider = arrangement(places, frame.edges, snap);
    if (loose_end(frame, wider) < 0) return wider;
  }
  const Vector2d& at = cut.points[std::size_t(cut.segments[std::size_t(loose)][0])];
  throw Error(where + ": a fold ends loosely near (" + std::to_string(at.x()) + ", " +
              std::to_string(at.y()) + "); let it meet another line");
}

// The frame with its lines cut at their crossings, and the faces between them.
FoldFrame with_faces(const FoldFrame& frame, const std::string& where) {
  const Arrangement cut = drawn_lines(frame, where);
  FoldFrame result;
  result.title = frame.title;
  result.unit = frame.unit;
  result.classes = frame.classes;
  for (const Vector2d& p : cut.points) result.vertices.emplace_back(p.x(), p.y(), 0.0);
  std::vector<int> line_of(cut.segments.size(), -1);
  for (std::size_t line = 0; line < frame.edges.size(); ++line) {
    for (const int s : cut.segments_of[line]) {
      // Where lines lie on each other the border gives way: a contour is often drawn twice.
      int& owner = line_of[std::size_t(s)];
      if (owner < 0 || frame.crease(owner) == Crease::border) owner = int(line);
    }
  }
  for (std::size_t s = 0; s < cut.segments.size(); ++s) {
    const auto [left, right] = cut.cells_of[s];
    const Crease crease = frame.crease(line_of[s]);
    if (left == right) continue;  // outside, or a line that is no fold and ends inside a face
    const bool border = left < 0 || right < 0;
    result.edges.push_back(cut.segments[s]);
    result.assignment.push_back(border                     ? Crease::border
                                : crease == Crease::border ? Crease::flat
                                                           : crease);
    if (!frame.fold_angle_deg.empty()) {
      result.fold_angle_deg.push_back(frame.fold_angle_deg[std::size_t(line_of[s])]);
    }
  }
  // Lines that were left out leave spurs in the walk around their face.
  for (auto cell : cut.cells) {
    for (bool changed = true; changed && cell.size() > 2;) {
      changed = false;
      for (std::size_t i = 0; i < cell.size() && !changed; ++i) {
        const std::size_t next = (i + 1) % cell.size(), after = (i + 2) % cell.size();
        if (cell[i] != cell[after]) continue;
        for (const std::size_t at : {std::max(next, after), std::min(next, after)}) {
          cell.erase(cell.begin() + std::ptrdiff_t(at));
        }
        changed = true;
      }
    }
    if (cell.size() > 2) result.faces.push_back(std::move(cell));
  }
  return result;
}

// Gives each side of an edge the side that follows it: along its face, or along the border.
void link_border(Sheet& sheet) {
  std::vector<int> leaving(sheet.flat.size(), -1);
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    if (sheet.half(h).face < 0) leaving[std::size_t(sheet.origin(h))] = h;
  }
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    if (sheet.half(h).face < 0)
      sheet.halves[std::size_t(h)].next = leaving[std::size_t(sheet.target(h))];
  }
}

void expect_one_part(const Sheet& sheet, const std::string& where) {
  std::vector<bool> reached(std::size_t(sheet.faces()), false);
  std::vector<int> open{0};
  int count = 0;
  reached[0] = true;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    ++count;
    for (const int h : sheet.halves_of(face)) {
      const int other = sheet.half(h ^ 1).face;
      if (other < 0 || reached[std::size_t(other)]) continue;
      reached[std::size_t(other)] = true;
      open.push_back(other);
    }
  }
  if (count < sheet.faces()) {
    throw Error(where + ": the sheet falls into parts; join them, or give one at a time");
  }
}

}  // namespace

std::vector<int> Sheet::halves_of(int face) const {
  std::vector<int> around;
  int h = face_halves[std::size_t(face)];
  do {
    around.push_back(h);
    h = half(h).next;
  } while (h != around.front());
  return around;
}

std::vector<int> Sheet::corners_of(int face) const {
  std::vector<int> around = halves_of(face);
  for (int& h : around) h = origin(h);
  return around;
}

Sheet sheet_of(const FoldFrame& given, const std::string& where) {
  if (given.edges.empty()) throw Error(where + ": has no edges; a sheet needs its border at least");
  for (const auto& vertex : given.vertices) {
    if (vertex.z() != 0.0) {
      throw Error(where + ": is not flat; give the crease pattern, not the folded form");
    }
  }
  const FoldFrame frame = given.faces.empty() ? with_faces(given, where) : given;
  if (frame.faces.empty()) {
    throw Error(where + ": its lines enclose no face; draw the border of the sheet");
  }
  Sheet sheet;
  for (const auto& vertex : frame.vertices) {
    sheet.flat.push_back(vertex.head<2>());
    sheet.folded.push_back(vertex);
  }
  std::map<std::array<int, 2>, int> half_at;  // by origin and target
  for (std::size_t e = 0; e < frame.edges.size(); ++e) {
    const auto [from, to] = frame.edges[e];
    if (half_at.contains({from, to})) {
      throw Error(where + ": edge " + std::to_string(e) + " is there twice; keep one of them");
    }
    half_at[{from, to}] = 2 * int(e);
    half_at[{to, from}] = 2 * int(e) + 1;
    sheet.halves.push_back({from, -1, -1});
    sheet.halves.push_back({to, -1, -1});
    const Crease crease = frame.crease(int(e));
    sheet.creases.push_back(crease);
    const double angle = frame.fold_angle_deg.empty() ? std::nan("") : frame.fold_angle_deg[e];
    sheet.fold_angles.push_back(std::isfinite(angle) ? angle * std::numbers::pi / 180.0
                                                     : default_angle(crease));
  }
  for (std::size_t f = 0; f < frame.faces.size(); ++f) {
    std::vector<int> corners = frame.faces[f];
    const double area = area_of(corners, frame.vertices);
    const std::string name = where + ": face " + std::to_string(f);
    if (area == 0.0) throw Error(name + " has no area; leave it out");
    if (area < 0.0) std::reverse(corners.begin(), corners.end());
    std::vector<int> around;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto found = half_at.find({corners[i], corners[(i + 1) % corners.size()]});
      if (found == half_at.end()) {
        throw Error(name + " has a side between vertices " + std::to_string(corners[i]) + " and " +
                    std::to_string(corners[(i + 1) % corners.size()]) + " that is no edge; add it");
      }
      HalfEdge& half = sheet.halves[std::size_t(found->second)];
      if (half.face >= 0) {
        throw Error(name + " lies over face " + std::to_string(half.face) +
                    "; faces of a flat sheet must not overlap");
      }
      half.face = int(f);
      around.push_back(found->second);
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
      sheet.halves[std::size_t(around[i])].next = around[(i + 1) % around.size()];
    }
    sheet.face_halves.push_back(around[0]);
  }
  for (int e = 0; e < sheet.edges(); ++e) {
    if (sheet.is_border(e)) sheet.creases[std::size_t(e)] = Crease::border;
    if (sheet.is_border(e)) sheet.fold_angles[std::size_t(e)] = 0.0;
  }
  link_border(sheet);
  expect_one_part(sheet, where);
  return sheet;
}

FoldFrame flat_frame(const Sheet& sheet) {
  FoldFrame frame;
  frame.classes = {"creasePattern"};
  for (const Vector2d& p : sheet.flat) frame.vertices.emplace_back(p.x(), p.y(), 0.0);
  for (int e = 0; e < sheet.edges(); ++e) {
    frame.edges.push_back({sheet.origin(2 * e), sheet.target(2 * e)});
    frame.fold_angle_deg.push_back(sheet.fold_angles[std::size_t(e)] * 180.0 / std::numbers::pi);
  }
  frame.assignment = sheet.creases;
  for (int f = 0; f < sheet.faces(); ++f) frame.faces.push_back(sheet.corners_of(f));
  return frame;
}

FoldFrame folded_frame(const Sheet& sheet) {
  FoldFrame frame = flat_frame(sheet);
  frame.classes = {"foldedForm"};
  frame.vertices = sheet.folded;
  frame.flat = std::all_of(sheet.folded.begin(), sheet.folded.end(),
                           [](const Eigen::Vector3d& p) { return p.z() == 0.0; });
  return frame;
}

Sheet square_sheet(double side) {
  FoldFrame frame;
  frame.vertices = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
  frame.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  frame.assignment.assign(4, Crease::border);
  frame.faces = {{0, 1, 2, 3}};
  return sheet_of(frame, "square");
}

}  // namespace hada
