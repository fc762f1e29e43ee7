#include "app/commands/block.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/block_file.h"
#include "app/draw/cut_picture.h"
#include "app/draw/maps.h"
#include "app/files.h"
#include "app/material_file.h"
#include "app/telling.h"
#include "core/error.h"
#include "fit/block_cut.h"
#include "io/json.h"

namespace hada {
namespace {

constexpr double ninety = 1.6449;  // deviations on each side that hold 90 % of a Gaussian
constexpr int station_px = 2;

Json as_json(const Known& known) {
  return {{"value", known.value},
          {"low", known.value - ninety * known.sigma},
          {"high", known.value + ninety * known.sigma}};
}

/// Every ring line as a list of [x, y, half the width of its band]; lengths in the unit.
Json json_of_cut(const std::string& name, const CutPrediction& cut, const BlockFit& block) {
  Json json = {{"hada", "cut/1"},
               {"name", name},
               {"unit", name_of(cut.extent.unit)},
               {"origin_mm", cut.cut.origin},
               {"right", cut.cut.right},
               {"up", cut.cut.up},
               {"pitch_mm", cut.extent.pitch},
               {"size_px", {cut.extent.cols, cut.extent.rows}},
               {"interval", 0.9}};
  Json lines = Json::array();
  int run = -1;
  for (const RingStation& station : cut.rings) {
    if (station.run != run) {
      run = station.run;
      lines.push_back({{"ring", station.ring + 1},
                       {"radius_mm", block.solid.radii[station.ring]},
                       {"points", Json::array()}});
    }
    lines.back()["points"].push_back(
        {station.place.x(), station.place.y(), ninety * station.sigma});
  }
  json["ring_lines"] = std::move(lines);
  if (!cut.slopes.empty()) {
    json["mean_slope"] = as_json(cut.mean_slope);
    Json slopes = Json::array();
    for (const CutSlope& one : cut.slopes) {
      slopes.push_back({one.place.x(), one.place.y(), one.slope.value, ninety * one.slope.sigma});
    }
    json["slopes"] = std::move(slopes);
  }
  return json;
}

/// The faces named `names`, taken out of `block`.
std::vector<PlacedFace> taken_out(BlockFile& block, const std::vector<std::string>& names) {
  std::vector<PlacedFace> taken;
  for (const std::string& name : names) {
    const auto face = std::find_if(block.faces.begin(), block.faces.end(),
                                   [&](const PlacedFace& one) { return one.name == name; });
    if (face == block.faces.end()) throw Error("block: there is no face " + name + " to leave out");
    taken.push_back(std::move(*face));
    block.faces.erase(face);
  }
  return taken;
}

}  // namespace

void block_command(const BlockArguments& arguments, const Terminal& terminal) {
  terminal.step("reading " + arguments.block.string());
  BlockFile file = read_block(arguments.block);
  const auto left_out = taken_out(file, arguments.left_out);
  terminal.step("following rings over the faces");
  const BlockFit block = fit_block(file.faces);

  Output output(arguments.out);
  MaterialFile material;
  material.material = block.wood.material;
  material.sigma = block.wood.sigma;
  material.starts = block.wood.starts;
  material.agreeing = block.wood.agreeing;
  material.remarks = block.wood.remarks;
  material.unit = file.faces.front().surface.extent.unit;
  const std::string text = material_text(material);
  put_text(output, "wood.json", text);
  const auto put_cut = [&](const NamedCut& asked, const Surface* seen) {
    terminal.step("predicting " + asked.name);
    const CutPrediction cut = predicted(block, asked.cut, asked.extent, station_px);
    put_text(output, asked.name + ".json", json_of_cut(asked.name, cut, block).dump(1) + "\n");
    const Image made = albedo_picture(cut.picture);
    const Image drawn = cut_picture(made, cut);
    put_picture(output, asked.name + ".png",
                seen ? beside(drawn, cut_picture(albedo_picture(*seen), cut)) : drawn);
  };
  for (const PlacedFace& face : left_out)
    put_cut({face.name, face.cut, face.surface.extent}, &face.surface);
  for (const NamedCut& asked : file.cuts) put_cut(asked, nullptr);
  output.commit();

  for (const auto& line : told(material)) terminal.say(line);
  for (std::size_t k = 0; k < file.faces.size(); ++k) {
    terminal.say(fmt::format(
        "{}: rings seen at {} places, {:.2f} px beside where they are expected", file.faces[k].name,
        block.faces[k].sightings, block.faces[k].scatter / file.faces[k].surface.extent.pitch));
  }
  for (const auto& remark : material.remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  terminal.result(text);
}

}  // namespace hada
