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
  return row({"in a browser: from the start of the program to a sheet that can be folded, s", "1",
              fmt::format("{:.2f}", json["ready_s"].get<double>()),
              verdict(json["ready_s"].get<double>() <= 1.0)}) +
         row({fmt::format("pointer move to drawn frame while dragging, median, ms ({})",
                          json["renderer"].get<std::string>()),
              "16.7 on native WebGL", fmt::format("{:.0f}", json["drag_frame_ms"].get<double>()),
              ""}) +
         row({"relighting 2048 x 2048, frames/s (same renderer)", "30 on native WebGL",
              fmt::format("{:.0f}", json["relight_fps"].get<double>()), ""});
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
