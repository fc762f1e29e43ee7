#include "studio/job_api.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <system_error>

#include "app/material_file.h"
#include "app/report/light_plot.h"
#include "app/telling.h"
#include "core/error.h"
#include "io/json.h"
#include "io/lights_file.h"
#include "studio/folder.h"
#include "studio/gate.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

// A plain name for what is to be written into the folder, where nothing has it yet.
fs::path fresh_place(const fs::path& folder, const std::string& name) {
  const bool plain = !name.empty() && name.size() < 100 && name[0] != '.' && name[0] != '-' &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return std::isalnum(c) || c == '-' || c == '_' || c == '.';
                     });
  if (!plain) throw Error("the name of what is written: use letters, digits, '-', '_' and '.'");
  if (fs::symlink_status(folder / name).type() != fs::file_type::not_found) {
    throw Error(name + ": is there already; choose another name");
  }
  return folder / name;
}

// Boxes of spheres as the command line takes them.
void add_boxes(JsonObject& object, std::vector<std::string>& words) {
  constexpr std::size_t most_spheres = 20;
  constexpr double most_px = 1e6;
  const Json& boxes = object.list("boxes");
  const auto good = [](const Json& box) {
    const auto in_range = [](const Json& x) {
      return x.is_number() && x.get<double>() >= 0.0 && x.get<double>() <= most_px;
    };
    return box.is_array() && box.size() == 4 && std::all_of(box.begin(), box.end(), in_range);
  };
  if (boxes.size() > most_spheres || !std::all_of(boxes.begin(), boxes.end(), good)) {
    object.fail("boxes", "must be at most 20 boxes [left, top, right, bottom] in pixels");
  }
  for (const Json& box : boxes) {
    words.push_back("--sphere");
    for (const Json& x : box) words.push_back(std::to_string(x.get<double>()));
  }
}

/// A lights file, and what it looks like.
std::string lights_answer(const fs::path& path) {
  constexpr double magnified = 10.0;
  const LightsFile file = read_lights(path);
  return Json{{"file", Json::parse(text_of_file(path))},
              {"magnified", magnified},
              {"sigma_deg", direction_sigma_deg(file.lights)},
              {"plot", light_plot({{"in force", file.lights}}, magnified)}}
      .dump();
}

}  // namespace

fs::path JobApi::fresh_result(const std::string& name) const {
  const fs::path place = scratch_.path() / name;
  std::error_code ignored;
  if (job_.state().state != "running") fs::remove(place, ignored);
  return place;
}

void JobApi::start(const std::string& verb, const std::string& body) {
  const Json json = parsed_json(body, "the request");
  JsonObject object(json, "the request");
  if (verb == "calibrate") {
    const std::string name = object.text("capture");
    std::vector<std::string> words{program_, "calibrate", place_within(folder_, name).string(),
                                   "-o", fresh_result("lights.json").string()};
    if (object.has("boxes")) add_boxes(object, words);
    object.finish();
    job_.start("lights of " + name, words);
  } else if (verb == "reconstruct") {
    const std::string name = object.text("capture");
    const fs::path out = fresh_place(folder_, object.text("out"));
    std::vector<std::string> words{program_, "reconstruct", place_within(folder_, name).string(),
                                   "-o", out.string()};
    if (object.flag("by_lights", false)) {
      words.insert(words.end(), {"--lights", (scratch_.path() / "lights.json").string()});
    }
    object.finish();
    job_.start("reconstruct " + name, words);
  } else if (verb == "fit") {
    const std::string material = object.text("material"), name = object.text("input");
    object.finish();
    material_named(material);  // or an Error that lists the names
    job_.start("fit " + material + " to " + name,
               {program_, "fit", material, place_within(folder_, name).string(), "-o",
                fresh_result("fit.json").string()});
  } else {
    throw Error("job/" + verb + ": there is no such request");
  }
}

std::string JobApi::state_text(const JobState& state) const {
  Json lines = Json::array();
  for (const auto& line : state.lines) {
    // What the program says may end within a letter of several bytes.
    const Json text = without_folder(folder_, line);
    lines.push_back(Json::parse(text.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }
  return Json{{"job", state.number},
              {"changes", state.changes},
              {"what", state.what},
              {"state", state.state},
              {"lines", lines}}
      .dump();
}

HttpResponse JobApi::answer(const std::string& verb, const HttpRequest& request) {
  if (request.method == "GET" && verb == "state") return {.body = state_text(job_.state())};
  if (request.method == "GET" && (verb == "lights" || verb == "fit")) {
    const fs::path place = scratch_.path() / (verb + ".json");
    if (!fs::exists(place)) throw Error("there is no result of that work yet; start it");
    return {.body = verb == "lights" ? lights_answer(place) : text_of_file(place)};
  }
  if (request.method == "GET" && verb == "events") {
    const auto seen = std::make_shared<int>(-1);
    return {.type = "text/event-stream", .stream = [this, seen](std::string& piece) {
              const JobState state = job_.wait(*seen);
              // A line of nothing tells whether the page is still there.
              piece = state.changes == *seen ? ":\n\n" : "data: " + state_text(state) + "\n\n";
              *seen = state.changes;
              return true;
            }};
  }
  if (request.method != "POST") throw Error("job/" + verb + ": there is no such request");
  if (verb == "cancel") {
    job_.cancel();
    return {.body = state_text(job_.state())};
  }
  try {
    start(verb, request.body);
    return {.body = state_text(job_.state())};
  } catch (const Error& error) {
    const bool busy = job_.state().state == "running";
    return told(busy ? 409 : 422, without_folder(folder_, error.what()));
  }
}

}  // namespace hada
