#include "io/crease_lines.h"

#include <cmath>
#include <map>
#include <sstream>

#include "core/error.h"

namespace hada {
namespace {

void add_line(FoldFrame& frame, Crease crease, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, const std::string& where) {
  if (!from.allFinite() || !to.allFinite()) {
    throw Error(where + ": a line ends nowhere; write finite numbers");
  }
  if (from == to) return;
  const int first = int(frame.vertices.size());
  frame.vertices.emplace_back(from.x(), from.y(), 0.0);
  frame.vertices.emplace_back(to.x(), to.y(), 0.0);
  frame.edges.push_back({first, first + 1});
  frame.assignment.push_back(crease);
}

// The kinds of ORIPA: 0 auxiliary, 1 contour, 2 mountain, 3 valley, 4 auxiliary.
Crease crease_of_oripa(int kind, const std::string& where) {
  switch (kind) {
    case 0:
    case 4:
      return Crease::flat;
    case 1:
      return Crease::border;
    case 2:
      return Crease::mountain;
    case 3:
      return Crease::valley;
  }
  throw Error(where + ": " + std::to_string(kind) + " is no kind of crease; use 0 to 4");
}

}  // namespace

FoldFrame lines_of_cp(const std::string& text, const std::string& where) {
  FoldFrame frame;
  std::istringstream stream(text);
  std::string line;
  for (int row = 1; std::getline(stream, line); ++row) {
    std::istringstream words(line);
    std::string first;
    if (!(words >> first)) continue;
    const std::string place = where + ": line " + std::to_string(row);
    std::istringstream again(line);
    int kind = 0;
    Eigen::Vector2d from, to;
    if (!(again >> kind >> from.x() >> from.y() >> to.x() >> to.y())) {
      throw Error(place + ": must be a kind and four numbers, x1 y1 x2 y2");
    }
    add_line(frame, crease_of_oripa(kind, place), from, to, place);
  }
  if (frame.edges.empty()) throw Error(where + ": holds no line; write one for each crease");
  return frame;
}

FoldFrame lines_of_opx(const std::string& text, const std::string& where) {
  FoldFrame frame;
  const std::string bean = "oripa.OriLineProxy";
  // One bean for each line; what a bean does not name is zero.
  for (std::size_t at = text.find(bean); at != std::string::npos;) {
    const std::size_t begin = at + bean.size();
    at = text.find(bean, begin);
    const std::string part = text.substr(begin, at == std::string::npos ? at : at - begin);
    const auto number = [&](const std::string& name) {
      std::size_t place = part.find("property=\"" + name + "\"");
      if (place == std::string::npos) return 0.0;
      place = part.find('>', part.find('<', place));  // past <int> or <double>
      if (place == std::string::npos) throw Error(where + ": is cut off; fetch it again");
      const char* digits = part.c_str() + place + 1;
      char* end = nullptr;
      const double value = std::strtod(digits, &end);
      if (end == digits) throw Error(where + ": " + name + " must be a number");
      return value;
    };
    const double kind = number("type");
    const int whole = std::abs(kind) < 100.0 ? int(kind) : -1;
    add_line(frame, crease_of_oripa(whole, where), {number("x0"), number("y0")},
             {number("x1"), number("y1")}, where);
  }
  if (frame.edges.empty()) throw Error(where + ": holds no " + bean + "; it is no file of ORIPA");
  return frame;
}

}  // namespace hada
