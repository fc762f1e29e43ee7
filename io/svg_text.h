#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace hada {

using SvgAttributes = std::map<std::string, std::string>;

/// A tag of an SVG file, names in small letters.
struct SvgTag {
  std::string name;
  SvgAttributes attributes;
  bool closes = false;  // </name>
  bool alone = false;   // <name ... />
};

/// The next tag from `at` on, comments and declarations passed over; none at the end.
/// throws  Error with `where` if it is broken off
std::optional<SvgTag> next_tag(const std::string& text, std::size_t& at, const std::string& where);

/// "a: b; c: d" as attributes.
SvgAttributes declarations(const std::string& text);

/// Rules of one class each, ".st0{stroke:#FF0000;}".
std::map<std::string, SvgAttributes> rules_of(const std::string& sheet);

/// "#f00", "#ff0000", "rgb(255, 0, 0)" and the names of the strongest colours; 0 to 255 each.
std::optional<std::array<int, 3>> colour_of(const std::string& text);

/// What a `transform` does, translate, scale, rotate and matrix.
Eigen::Affine2d transform_of(const std::string& text);

using SvgStrokes = std::vector<std::array<Eigen::Vector2d, 2>>;

/// The straight strokes of a line, polyline, polygon, rect or path, y down; curves are taken by
/// their ends. Other tags have none.
/// throws  Error with `where` if a path is broken off
SvgStrokes strokes_of(const SvgTag& tag, const std::string& where);

}  // namespace hada
