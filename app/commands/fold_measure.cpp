#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/commands/fold_shape.h"
#include "app/lit_capture.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "io/output.h"
#include "io/surface_file.h"
#include "measure/creases.h"
#include "reconstruct/reconstruct.h"
#include "sheet/unfold.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// A place as pixel coordinates (u, v) of the pictures that the surface was made from.
Json pixel_json(const Surface& surface, const Eigen::Vector2d& place) {
  const Eigen::Vector2d pixel = surface.extent.pixel(place);
  return {pixel.y() + 0.5 + surface.offset_px.x(), pixel.x() + 0.5 + surface.offset_px.y()};
}

Json crease_json(const Surface& surface, const MeasuredCrease& crease) {
  const std::string unit(name_of(surface.extent.unit));
  return {{"kind", crease.fold_angle > 0.0 ? "valley" : "mountain"},
          {"fold_angle_deg", crease.fold_angle / degree},
          {"fold_angle_sigma_deg", crease.fold_angle_sigma / degree},
          {"ends_" + unit, {{crease.from.x(), crease.from.y()}, {crease.to.x(), crease.to.y()}}},
          {"ends_px", {pixel_json(surface, crease.from), pixel_json(surface, crease.to)}},
          {"offset_sigma_px", crease.offset_sigma / surface.extent.pitch},
          {"width_" + unit, crease.width},
          {"width_sigma_" + unit, crease.width_sigma}};
}

// What is measured: a surface, and the pictures that it was made from where they are given.
struct Seen {
  Surface surface;
  std::optional<LitCapture> lit;
  std::vector<std::string> remarks;
};

Seen seen_in(const FoldMeasureArguments& arguments, const Terminal& terminal) {
  Seen seen;
  if (std::filesystem::exists(arguments.input / "surface.json") ||
      !std::filesystem::is_directory(arguments.input)) {
    if (arguments.lights)
      throw Error("--lights: belongs to a folder of pictures, not to a surface");
    terminal.step("reading " + arguments.input.string());
    seen.surface = read_surface(arguments.input, arguments.pitch_mm);
    return seen;
  }
  seen.lit = lit_capture(load_folder(arguments.input, terminal, arguments.pitch_mm),
                         arguments.lights, terminal);
  terminal.step("reconstructing normals");
  Reconstruction result = reconstruct(seen.lit->stack);
  seen.remarks = seen.lit->remarks;
  seen.remarks.insert(seen.remarks.end(), result.remarks.begin(), result.remarks.end());
  seen.surface = std::move(result.surface);
  return seen;
}

}  // namespace

void fold_measure_command(const FoldMeasureArguments& arguments, const Terminal& terminal) {
  const Seen seen = seen_in(arguments, terminal);
  const Surface& surface = seen.surface;
  terminal.step("measuring creases");
  MeasuredCreases found;
  try {
    found = measured_creases(surface, {.smallest_fold_deg = arguments.smallest_deg},
                             seen.lit ? &seen.lit->stack : nullptr);
  } catch (const Error& error) {
    throw Error(arguments.input.string() + ": " + error.what());
  }
  FoldFile file;
  file.title = arguments.input.filename().string();
  const Sheet sheet = unfolded_sheet(found.frame, arguments.input.string());
  file.frames = {folded_frame(sheet), flat_frame(sheet)};
  for (FoldFrame& frame : file.frames) frame.unit = found.frame.unit;
  write_text(arguments.out, fold_text(file));
  Json json = {{"hada", "fold_measure/1"}, {"unit", found.frame.unit}, {"faces", sheet.faces()}};
  json["creases"] = Json::array();
  terminal.say(fmt::format("{} creases between {} facets", found.creases.size(), sheet.faces()));
  for (const MeasuredCrease& crease : found.creases) {
    json["creases"].push_back(crease_json(surface, crease));
    terminal.say(fmt::format(
        "  {:<8} {:7.3f} deg +- {:.3f}, line known to {:.3f} px, bend {:.2f} +- {:.2f} px wide",
        crease.fold_angle > 0.0 ? "valley" : "mountain", std::abs(crease.fold_angle) / degree,
        crease.fold_angle_sigma / degree, crease.offset_sigma / surface.extent.pitch,
        crease.width / surface.extent.pitch, crease.width_sigma / surface.extent.pitch));
  }
  json["inner_vertices"] = Json::array();
  for (const MeasuredVertex& vertex : found.inner_vertices) {
    json["inner_vertices"].push_back({{"place", {vertex.place.x(), vertex.place.y()}},
                                      {"creases", vertex.creases},
                                      {"closure_deg", vertex.closure / degree},
                                      {"closure_sigma_deg", vertex.closure_sigma / degree}});
    terminal.say(
        fmt::format("  {} creases meet at ({:.2f}, {:.2f}); a full turn lacks {:.3f} deg +- {:.3f}",
                    vertex.creases, vertex.place.x(), vertex.place.y(), vertex.closure / degree,
                    vertex.closure_sigma / degree));
  }
  for (std::size_t k = 0; k < found.lights_turned.size(); ++k) {
    json["lights"].push_back({{"image", seen.lit->stack.lights[k].image},
                              {"corrected_deg", found.lights_turned[k] / degree}});
  }
  if (!found.lights_turned.empty()) {
    const double most = *std::max_element(found.lights_turned.begin(), found.lights_turned.end());
    terminal.say(
        fmt::format("lights corrected by the sheet itself: {:.2f} deg at most", most / degree));
  }
  if (seen.lit && found.lights_turned.empty()) {
    terminal.say(
        "note: a facet lies without shadows in less than three pictures; lights are not "
        "corrected");
  }
  for (const std::string& remark : seen.remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  terminal.result(json.dump(1));
}

}  // namespace hada
