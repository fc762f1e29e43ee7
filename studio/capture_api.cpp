#include "studio/capture_api.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <system_error>

#include "app/draw/maps.h"
#include "core/error.h"
#include "io/capture_folder.h"
#include "io/image_file.h"
#include "io/json.h"
#include "studio/folder.h"
#include "studio/gate.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 3;
constexpr std::size_t fewest_pictures = 3;  // of a capture
constexpr std::size_t most_captures = 100;

// Folders that hold pictures enough, without what is hidden or lies behind links.
void gather(const fs::path& root, const fs::path& folder, int depth, Json& captures) {
  std::error_code problem;
  const auto pictures = sorted_folder(folder).pictures;
  if (pictures.size() >= fewest_pictures) {
    const std::string name = folder == root ? "" : fs::relative(folder, root).generic_string();
    captures.push_back({{"name", name}, {"pictures", pictures}});
  }
  std::vector<fs::path> inside;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string name = entry.path().filename().string();
    const bool seen = !name.starts_with(".") && name != "node_modules";
    if (seen && !entry.is_symlink(problem) && entry.is_directory(problem)) {
      inside.push_back(entry.path());
    }
  }
  std::sort(inside.begin(), inside.end());
  for (const fs::path& path : inside) {
    if (depth < deepest && captures.size() < most_captures) {
      gather(root, path, depth + 1, captures);
    }
  }
}

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

}  // namespace

HttpResponse CaptureApi::capture(const std::string& verb, const HttpRequest& request) const {
  if (request.method == "GET" && verb == "list") {
    Json captures = Json::array();
    gather(folder_, folder_, 0, captures);
    return {.body = Json{{"captures", captures}}.dump()};
  }
  if (request.method == "GET" && verb == "picture") {
    const auto place = place_within(folder_, request.word("name"));
    const ImageFile file = read_image(place);
    const auto png = encode_png(thumbnail(file.image, file.floating, 480));
    return {.type = "image/png",
            .body = std::string(png.begin(), png.end()),
            .headers = {{"X-Rows", std::to_string(file.image.rows())},
                        {"X-Cols", std::to_string(file.image.cols())}}};
  }
  if (request.method == "GET" && verb == "lights") {
    return {.body = text_of_file(scratch_.path() / "lights.json")};
  }
  throw Error("capture/" + verb + ": there is no such request");
}

HttpResponse CaptureApi::started(const std::string& verb, const std::string& body) {
  const Json json = parsed_json(body, "the request");
  JsonObject object(json, "the request");
  if (verb == "calibrate") {
    const std::string name = object.text("capture");
    object.finish();
    std::error_code ignored;
    const auto lights = scratch_.path() / "lights.json";
    if (job_.state().state != "running") fs::remove(lights, ignored);
    job_.start("lights of " + name, {program_, "calibrate", place_within(folder_, name).string(),
                                     "-o", lights.string()});
  } else if (verb == "reconstruct") {
    const std::string name = object.text("capture");
    const fs::path out = fresh_place(folder_, object.text("out"));
    object.finish();
    job_.start("reconstruct " + name,
               {program_, "reconstruct", place_within(folder_, name).string(), "-o", out.string()});
  } else if (verb == "fit") {
    const std::string material = object.text("material"), name = object.text("input");
    const fs::path out = fresh_place(folder_, object.text("out"));
    object.finish();
    if (material.empty() || !std::all_of(material.begin(), material.end(),
                                         [](unsigned char c) { return std::islower(c) != 0; })) {
      throw Error("the name of a material has small letters only");
    }
    job_.start(
        "fit " + material + " to " + name,
        {program_, "fit", material, place_within(folder_, name).string(), "-o", out.string()});
  } else {
    throw Error("job/" + verb + ": there is no such request");
  }
  return {.body = state_text(job_.state())};
}

std::string CaptureApi::state_text(const JobState& state) const {
  Json lines = Json::array();
  for (const auto& line : state.lines) {
    // What the program says may end within a letter of several bytes.
    const Json text = without_folder(folder_, line);
    lines.push_back(Json::parse(text.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }
  return Json{{"job", state.number}, {"what", state.what}, {"state", state.state}, {"lines", lines}}
      .dump();
}

HttpResponse CaptureApi::job(const std::string& verb, const HttpRequest& request) {
  if (request.method == "GET" && verb == "state") return {.body = state_text(job_.state())};
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
    return started(verb, request.body);
  } catch (const Error& error) {
    const bool busy = job_.state().state == "running";
    return told(busy ? 409 : 422, without_folder(folder_, error.what()));
  }
}

}  // namespace hada
