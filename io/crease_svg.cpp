#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/error.h"
#include "io/crease_lines.h"
#include "io/svg_text.h"

namespace hada {
namespace {

using Eigen::Vector2d;

std::optional<Crease> crease_of(const std::string& stroke) {
  const auto colour = colour_of(stroke);
  if (!colour) return std::nullopt;
  const auto on = [&](int channel) { return (*colour)[std::size_t(channel)] >= 100; };
  const int code = (on(0) ? 4 : 0) + (on(1) ? 2 : 0) + (on(2) ? 1 : 0);
  switch (code) {
    case 0:
      return Crease::border;
    case 4:
      return Crease::mountain;
    case 1:
      return Crease::valley;
    case 6:
      return Crease::flat;
    case 2:
      return Crease::cut;
    case 5:
      return Crease::unassigned;
  }
  return std::nullopt;
}

// What groups hand down.
struct Style {
  Eigen::Affine2d to_page = Eigen::Affine2d::Identity();
  std::string stroke;
  double opacity = 1.0;
};

Style inner(const Style& outer, const SvgTag& tag,
            const std::map<std::string, SvgAttributes>& rules) {
  SvgAttributes all = tag.attributes;
  const auto add = [&](const SvgAttributes& more) {
    for (const auto& [key, value] : more) all[key] = value;
  };
  if (const auto rule = rules.find(tag.attributes.contains("class") ? all["class"] : "");
      rule != rules.end()) {
    add(rule->second);
  }
  if (tag.attributes.contains("style")) add(declarations(tag.attributes.at("style")));
  Style style = outer;
  if (all.contains("transform")) style.to_page = outer.to_page * transform_of(all["transform"]);
  if (all.contains("stroke")) style.stroke = all["stroke"];
  for (const char* key : {"opacity", "stroke-opacity"}) {
    if (!all.contains(key)) continue;
    style.opacity *= std::clamp(std::strtod(all[key].c_str(), nullptr), 0.0, 1.0);
  }
  return style;
}

}  // namespace

FoldFrame lines_of_svg(const std::string& text, const std::string& where) {
  FoldFrame frame;
  std::map<std::string, SvgAttributes> rules;
  std::vector<Style> styles{Style{}};
  std::size_t at = 0;
  while (const auto tag = next_tag(text, at, where)) {
    if (tag->closes) {
      if (styles.size() > 1) styles.pop_back();
      continue;
    }
    if (tag->name == "style" && !tag->alone) {
      rules = rules_of(text.substr(at + 1, text.find("</", at) - at - 1));
    }
    const Style style = inner(styles.back(), *tag, rules);
    if (!tag->alone) styles.push_back(style);
    const auto crease = crease_of(style.stroke);
    if (!crease) continue;
    for (const auto& stroke : strokes_of(*tag, where)) {
      // y down on the page, up in the frame of the sheet.
      const Vector2d from = style.to_page * stroke[0], to = style.to_page * stroke[1];
      if (!from.allFinite() || !to.allFinite()) {
        throw Error(where + ": a line ends nowhere; write finite numbers");
      }
      if (from == to) continue;
      const int first = int(frame.vertices.size());
      frame.vertices.emplace_back(from.x(), -from.y(), 0.0);
      frame.vertices.emplace_back(to.x(), -to.y(), 0.0);
      frame.edges.push_back({first, first + 1});
      frame.assignment.push_back(*crease);
      const double sign = *crease == Crease::mountain ? -1.0 : 1.0;
      const bool bends = *crease == Crease::mountain || *crease == Crease::valley;
      frame.fold_angle_deg.push_back(bends                           ? sign * 180.0 * style.opacity
                                     : *crease == Crease::unassigned ? std::nan("")
                                                                     : 0.0);
    }
  }
  if (frame.edges.empty()) {
    throw Error(where + ": holds no coloured line; draw mountains red, valleys blue, border black");
  }
  return frame;
}

}  // namespace hada
