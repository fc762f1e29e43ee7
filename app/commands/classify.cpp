#include "app/commands/classify.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/files.h"
#include "app/material_file.h"
#include "app/measurement.h"
#include "core/error.h"
#include "fit/classify.h"
#include "io/json.h"
#include "io/output.h"
#include "io/surface_file.h"
#include "measure/measured_map.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double least_goodness = 1e-3;  // p below which a person is told

struct Kinds {
  std::vector<std::string> names;
  std::vector<Wrinkle<>> wrinkles;
};

Kinds kinds_in(const std::filesystem::path& folder, Unit unit) {
  if (!std::filesystem::is_directory(folder)) {
    throw Error(folder.string() + ": is no folder; give one with a wrinkle file for each kind");
  }
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  Kinds kinds;
  for (const auto& path : paths) {
    const MaterialFile file = read_material(path);
    const auto* wrinkle = std::get_if<Wrinkle<>>(&file.material);
    if (!wrinkle) {
      throw Error(path.string() + ": is a " + std::string(name_of(file.material)) +
                  "; only wrinkle files can be told apart here");
    }
    if (file.unit != unit) {
      throw Error(path.string() + ": is in " + std::string(name_of(file.unit)) +
                  " but the surface in " + std::string(name_of(unit)) +
                  "; give the surface a pitch (--pitch MM)");
    }
    kinds.names.push_back(path.stem().string());
    kinds.wrinkles.push_back(*wrinkle);
  }
  if (kinds.names.empty()) {
    throw Error(folder.string() + ": holds no .json file; put a wrinkle file for each kind there");
  }
  return kinds;
}

Json json_of(const std::string& name, const Likeness& likeness) {
  return {{"name", name},
          {"probability", likeness.probability},
          {"amplitude", likeness.amplitude},
          {"length", likeness.length},
          {"turn_rad", likeness.turn_rad},
          {"goodness_p", likeness.goodness_p}};
}

}  // namespace

void classify_command(const ClassifyArguments& arguments, const Terminal& terminal) {
  terminal.step("reading " + arguments.input.string());
  Surface surface = read_surface(arguments.input, arguments.pitch_mm);
  if (!surface.has_height()) surface.height = measured_map(surface);
  const auto folder = arguments.among.empty() ? shipped_recipe("papers") : arguments.among;
  const Kinds kinds = kinds_in(folder, surface.extent.unit);
  terminal.step("comparing with " + std::to_string(kinds.names.size()) + " kinds");
  const auto likenesses = classify(surface, kinds.wrinkles);

  std::vector<std::size_t> order(kinds.names.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return likenesses[a].probability > likenesses[b].probability;
  });
  Json json = {{"hada", "classify/1"}, {"kinds", Json::array()}};
  for (const std::size_t k : order) {
    const Likeness& one = likenesses[k];
    json["kinds"].push_back(json_of(kinds.names[k], one));
    terminal.say(fmt::format(
        "{:<16} {:6.1f} %   heights x {:.2f}, lengths x {:.2f}, turned by {:.0f} deg",
        kinds.names[k], 100.0 * one.probability, one.amplitude, one.length, one.turn_rad / degree));
  }
  if (likenesses[order.front()].goodness_p < least_goodness) {
    terminal.say("note: none of them explains the spectrum; the first is only the least unlike");
  }
  const std::string text = json.dump(1) + "\n";
  if (arguments.out) {
    write_text(*arguments.out, text);
    terminal.say("wrote " + arguments.out->string());
  }
  terminal.result(text);
}

}  // namespace hada
