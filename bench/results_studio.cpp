#include "bench/results_studio.h"

#include <algorithm>

#include <fmt/format.h>

#include "bench/results_page.h"
#include "bench/studio_study.h"
#include "core/quantile.h"
#include "io/json.h"

namespace hada {
namespace {

std::string drag_rows() {
  const auto s = study_drag(HADA_SOURCE_DIR "/data_synthetic/folds");
  return row({fmt::format("answer to a drag, {} faces, median, ms", s.faces), "5",
              fmt::format("{:.1f}", s.drag_ms), verdict(s.drag_ms <= 5.0)}) +
         row({"answer to a pointer that draws, the same sheet, median, ms", "5",
              fmt::format("{:.1f}", s.aim_ms), verdict(s.aim_ms <= 5.0)}) +
         row({"largest strain while dragging", "1e-3", fmt::format("{:.0e}", s.strain_dragging),
              verdict(s.strain_dragging <= 1e-3)}) +
         row({"largest strain on release", "1e-9", fmt::format("{:.0e}", s.strain_released),
              verdict(s.strain_released <= 1e-9)});
}

std::string preview_rows() {
  const auto s = study_previews();
  std::string rows;
  for (const auto& [name, ms] : s.material_ms) {
    rows += row({fmt::format("preview of {} at 512 x 512 while a slider moves, median, ms", name),
                 "100", fmt::format("{:.0f}", ms), verdict(ms <= 100.0)});
  }
  return rows +
         row({"steel folded in another way, ms", "", fmt::format("{:.0f}", s.other_folds_ms), ""});
}

std::string hostile_row() {
  const auto s = study_hostile();
  return row({fmt::format("hostile requests that succeed, of {}", s.tried), "0, server alive",
              fmt::format("{}, server {}", s.succeeded, s.alive ? "alive" : "dead"),
              verdict(s.succeeded == 0 && s.alive)});
}

std::string browser_rows(const std::filesystem::path& figures) {
  if (!std::filesystem::exists(figures)) {
    return row({"in a browser", "", "not measured: run tests/studio/browser/figures.mjs", ""});
  }
  const Json json = read_plain_json(figures);
  const auto number = [&](const char* name) { return json[name].get<double>(); };
  const double ready = number("ready_s"), drag = number("drag_page_ms") + number("drag_server_ms"),
               relight = number("relight_page_ms");
  const auto renderer = json["renderer"].get<std::string>();
  return row({"in a browser: from the start of the program to a sheet that can be folded, median "
              "of 5, "
              "s",
              "1", fmt::format("{:.2f}", ready), verdict(ready <= 1.0)}) +
         row({fmt::format("processor time of a frame while dragging, {} faces, but for drawing: "
                          "page and server, ms",
                          number("drag_faces")),
              "16.7",
              fmt::format("{:.1f} + {:.1f}", number("drag_page_ms"), number("drag_server_ms")),
              verdict(drag <= 1000.0 / 60.0)}) +
         row({"the same while relighting 2048 x 2048, ms", "33", fmt::format("{:.1f}", relight),
              verdict(relight <= 1000.0 / 30.0)}) +
         row({fmt::format("pointer move to drawn frame while dragging, median, ms ({})", renderer),
              "16.7 on native WebGL", fmt::format("{:.0f}", number("drag_frame_ms")), ""}) +
         row({"relighting 2048 x 2048, frames/s (same renderer)", "30 on native WebGL",
              fmt::format("{:.0f}", number("relight_fps")), ""});
}

}  // namespace

std::string studio_results(const std::filesystem::path& figures) {
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) seconds.push_back(seconds_to_page(HADA_PROGRAM));
  const double ready = median(seconds);
  return table("The studio", "| figure | must be | measured | |") +
         row({"from the start of the program to the page, median of 5, s", "1",
              fmt::format("{:.2f}", ready), verdict(ready <= 1.0)}) +
         drag_rows() + preview_rows() + hostile_row() + browser_rows(figures);
}

}  // namespace hada
