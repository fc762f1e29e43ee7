#include "app/material_file.h"

#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "app/files.h"
#include "app/material_list.h"
#include "io/json.h"

namespace hada {
namespace {

Material parameters_of(const std::string& name, JsonObject object) {
  Material material = material_named(name);
  std::visit([&](auto& m) { m = material_from<std::decay_t<decltype(m)>>(std::move(object)); },
             material);
  return material;
}

Unit unit_of(JsonObject& object) {
  const std::string unit = object.text("unit", "mm");
  if (unit != "mm" && unit != "px") object.fail("unit", "must be \"mm\" or \"px\"");
  return unit == "mm" ? Unit::mm : Unit::px;
}

std::vector<double> mean_albedo_of(JsonObject& object, const Material& material) {
  if (!std::holds_alternative<Wrinkle<>>(material)) {
    object.fail("mean_albedo", "is of wrinkles; other materials have colours of their own");
  }
  const bool coloured = object.list("mean_albedo").size() == 3;
  const std::vector<double> mean = object.numbers("mean_albedo", coloured ? 3 : 1);
  double sum = 0.0;
  for (const double value : mean) {
    if (!(value >= 0.0 && value <= 1e6)) object.fail("mean_albedo", "must lie between 0 and 1e6");
    sum += value;
  }
  if (!(sum > 0.0)) object.fail("mean_albedo", "must not be black");
  return mean;
}

MaterialFile::Input input_of(JsonObject object, Unit unit) {
  MaterialFile::Input input;
  input.name = object.text("path", "");
  input.hash = object.text("hash", "");
  input.extent.unit = unit;
  input.extent.pitch = object.number("pitch", 1.0);
  if (!(input.extent.pitch > 0.0)) object.fail("pitch", "must be greater than 0");
  if (object.has("size_px")) {
    const auto size = object.numbers("size_px", 2);
    input.extent.cols = int(size[0]);
    input.extent.rows = int(size[1]);
  }
  object.finish();
  return input;
}

// "components[1].long_mm" as JSON points at it.
Json::json_pointer pointer_of(const std::string& path) {
  std::string text = "/";
  for (const char c : path) {
    if (c != ']') text += c == '[' || c == '.' ? '/' : c;
  }
  return Json::json_pointer(text);
}

/// The standard deviations in `json`, laid out as the parameters of `material`; NaN where there is
/// none, as in a file whose parameters a person has changed, and 0 of what a file leaves out.
Material sigma_of(const Json& json, Material material) {
  std::visit(
      [&](auto& m) {
        visit_fields(m, [&](const std::string& path, const auto& field, double& value) {
          const auto pointer = pointer_of(path);
          const bool known = json.contains(pointer) && json.at(pointer).is_number();
          if (!known && is_left_out(field, value)) return;
          value = known ? json.at(pointer).get<double>() : std::nan("");
        });
      },
      material);
  return material;
}

/// What a fit says of itself. None of it is needed to make more of the material.
void read_record(const Json& json, JsonObject& object, MaterialFile& file) {
  if (object.has("sigma")) {
    file.sigma = sigma_of(json["sigma"], file.material);
  }
  file.goodness_p = object.number("goodness_p", file.goodness_p);
  file.runner_up_gap = object.number("runner_up_gap", file.runner_up_gap);
  if (object.has("starts")) file.starts = object.integer("starts");
  if (object.has("agreeing")) file.agreeing = object.integer("agreeing");
  try {
    if (object.has("on_bound")) json["on_bound"].get_to(file.on_bound);
    if (object.has("remarks")) json["remarks"].get_to(file.remarks);
    if (object.has("intervals")) {
      for (const auto& [path, ends] : json["intervals"].get_ref<const Json::object_t&>()) {
        const auto [low, high] = ends.get<std::array<double, 2>>();
        if (!(low <= high))
          throw Error(object.where() + ": the interval of " + path + " is empty; fit again");
        file.intervals.push_back({path, low, high});
      }
    }
    if (object.has("kinds")) {
      for (const auto& [kind, probability] : json["kinds"].items()) {
        file.kinds.emplace_back(kind, probability.get<double>());
      }
    }
    if (!object.has("choices")) return;
    for (const Json& choice : json["choices"]) {
      file.choices.push_back({choice.at("words"), choice.at("probability")});
    }
  } catch (const Json::exception&) {
    throw Error(object.where() + ": what the fit says of itself is damaged; fit again");
  }
}

MaterialFile::BeyondSpectrum::Side side_of(JsonObject object) {
  MaterialFile::BeyondSpectrum::Side side;
  side.chi_square = object.number("chi_square");
  side.height = object.number("height", side.height);
  side.slope = object.number("slope", side.slope);
  side.curvature = object.number("curvature", side.curvature);
  object.finish();
  return side;
}

MaterialFile::BeyondSpectrum beyond_spectrum_of(JsonObject object) {
  MaterialFile::BeyondSpectrum beyond{side_of(object.object("gaussian")),
                                      side_of(object.object("ridged"))};
  object.number("explained", 0.0);
  object.finish();
  return beyond;
}

Json json_of_side(const MaterialFile::BeyondSpectrum::Side& side) {
  Json json = {{"chi_square", side.chi_square}};
  if (!std::isfinite(side.height)) return json;
  json["height"] = side.height;
  json["slope"] = side.slope;
  json["curvature"] = side.curvature;
  return json;
}

Seed seed_of(JsonObject& object) {
  const double seed = object.number("seed");
  constexpr double most_exact = 9007199254740992.0;  // 2^53
  if (seed < 0.0 || seed > most_exact || seed != std::floor(seed)) {
    object.fail("seed", "must be a whole number from 0 to 2^53");
  }
  return Seed(seed);
}

}  // namespace

std::string hash_of(const Grid<float>& values) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int byte = 0; byte < 4; ++byte) {
      hash = (hash ^ (bits >> (8 * byte) & 0xffu)) * 0x100000001b3u;
    }
  }
  return fmt::format("{:016x}", hash);
}

std::string_view name_of(const Material& material) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::name; }, material);
}

std::string material_names() {
  std::string names;
  for_each_material([&](const auto& m) {
    names += (names.empty() ? "" : ", ") + std::string(std::decay_t<decltype(m)>::name);
  });
  return names;
}

Material material_named(const std::string& name) {
  std::optional<Material> found;
  for_each_material([&](const auto& m) {
    if (std::decay_t<decltype(m)>::name == name) found = m;
  });
  if (!found) {
    throw Error("\"" + name +
                "\" is not a material that hada knows; choose from: " + material_names());
  }
  return *found;
}

MaterialFile read_material(const std::filesystem::path& path) {
  return material_of(text_of_file(path), path.string());
}

MaterialFile material_of(const std::string& text, const std::string& where) {
  const Json json = json_of_kind(text, where, "material/1");
  JsonObject object(json, where);
  MaterialFile file;
  file.material = parameters_of(object.text("material"), object.object("parameters"));
  file.unit = unit_of(object);
  if (object.has("mean_albedo")) file.mean_albedo = mean_albedo_of(object, file.material);
  if (object.has("seed")) file.seed = seed_of(object);
  if (object.has("input")) file.input = input_of(object.object("input"), file.unit);
  read_record(json, object, file);
  if (object.has("beyond_spectrum"))
    file.beyond_spectrum = beyond_spectrum_of(object.object("beyond_spectrum"));
  object.has("version");
  object.finish();
  return file;
}

std::string material_text(const MaterialFile& file) {
  Json json = {{"hada", "material/1"}, {"material", name_of(file.material)}};
  const auto fields = [](const Material& material) {
    return std::visit([](const auto& m) { return json_of(m); }, material);
  };
  json["parameters"] = fields(file.material);
  if (file.sigma) json["sigma"] = fields(*file.sigma);
  json["unit"] = name_of(file.unit);
  if (!file.mean_albedo.empty()) json["mean_albedo"] = file.mean_albedo;
  if (std::isfinite(file.goodness_p)) json["goodness_p"] = file.goodness_p;
  if (file.starts > 0) {
    json["on_bound"] = file.on_bound;
    json["starts"] = file.starts;
    json["agreeing"] = file.agreeing;
  }
  for (const auto& [path, low, high] : file.intervals) json["intervals"][path] = {low, high};
  if (std::isfinite(file.runner_up_gap)) json["runner_up_gap"] = file.runner_up_gap;
  for (const auto& choice : file.choices)
    json["choices"].push_back({{"words", choice.words}, {"probability", choice.probability}});
  for (const auto& [kind, probability] : file.kinds) json["kinds"][kind] = probability;
  if (file.beyond_spectrum) {
    const auto& [gaussian, ridged] = *file.beyond_spectrum;
    json["beyond_spectrum"] = {{"gaussian", json_of_side(gaussian)},
                               {"ridged", json_of_side(ridged)},
                               {"explained", 1.0 - ridged.chi_square / gaussian.chi_square}};
  }
  if (!file.remarks.empty()) json["remarks"] = file.remarks;
  if (file.seed) json["seed"] = *file.seed;
  if (file.input) {
    json["input"] = {{"path", file.input->name},
                     {"hash", file.input->hash},
                     {"pitch", file.input->extent.pitch},
                     {"size_px", {file.input->extent.cols, file.input->extent.rows}}};
  }
  json["version"] = version();
  return json.dump(1) + "\n";
}

}  // namespace hada
