#include "studio/capture_api.h"

#include <algorithm>
#include <system_error>

#include "app/draw/maps.h"
#include "core/error.h"
#include "io/capture_folder.h"
#include "io/image_file.h"
#include "io/json.h"
#include "studio/folder.h"

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

}  // namespace

HttpResponse CaptureApi::answer(const std::string& verb, const HttpRequest& request) const {
  if (request.method == "GET" && verb == "list") {
    Json captures = Json::array();
    gather(folder_, folder_, 0, captures);
    return {.body = Json{{"captures", captures}}.dump()};
  }
  if (request.method == "GET" && verb == "picture") {
    const auto place = place_within(folder_, request.word("name"));
    const std::string size = request.word("size", "480");
    if (size != "480" && size != "1600") throw Error("a picture is shown with 480 or 1600 pixels");
    const ImageFile file = read_image(place);
    const auto png = encode_png(thumbnail(file.image, file.floating, std::stoi(size)));
    return {.type = "image/png",
            .body = std::string(png.begin(), png.end()),
            .headers = {{"X-Rows", std::to_string(file.image.rows())},
                        {"X-Cols", std::to_string(file.image.cols())}}};
  }
  throw Error("capture/" + verb + ": there is no such request");
}

}  // namespace hada
