// hada_results FILE: measures every figure that the project claims and writes them as a page.
// Real data that is absent is said to be absent; nothing here is written by hand.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "bench/accuracy.h"
#include "bench/light_study.h"
#include "bench/normals_speed.h"
#include "bench/normals_study.h"
#include "bench/process.h"
#include "bench/results_fold.h"
#include "bench/results_forged.h"
#include "bench/results_height.h"
#include "bench/results_knit.h"
#include "bench/results_loop.h"
#include "bench/results_page.h"
#include "bench/results_ridges.h"
#include "bench/results_studio.h"
#include "bench/results_wood.h"
#include "bench/results_wrinkle.h"
#include "core/quantile.h"

namespace {

namespace fs = std::filesystem;
using hada::Asked;
using hada::judged;
using hada::median;
using hada::row;
using hada::table;
using hada::verdict;

void say(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
}

std::string real_photographs() {
  const fs::path data = hada::data_folder();
  std::string page = table("Real photographs", "| figure | must be | measured | |");
  if (!fs::exists(data / "photos")) {
    return page + row({"all", "", "the photographs are not here: skipped", ""});
  }
  say("real photographs");
  const auto spheres = hada::sphere_agreement(data);
  page += row({"uw, chrome against grey sphere, light directions", "<= 2.0 deg mean",
               fmt::format("{:.2f} deg mean, {:.1f} at most", spheres.mean_deg, spheres.max_deg),
               verdict(spheres.mean_deg <= 2.0)});
  const double ball = hada::diligent_ball_error_deg(data);
  page +=
      row({"DiLiGenT ball, least squares, given lights (published 4.10)", "4.00 to 4.30 deg mean",
           fmt::format("{:.2f} deg mean", ball), verdict(ball >= 4.0 && ball <= 4.3)});
  for (const char* object : {"buddha", "cat", "rock"}) {
    const auto score = hada::relighting(data, object);
    page += row({fmt::format("uw {}, lights of the grey sphere", object), "complete",
                 fmt::format("{:.1f} % of its mask, relighting error {:.1f} % rms",
                             100.0 * score.pixels, 100.0 * score.relighting_error),
                 verdict(score.pixels > 0.95)});
  }
  return page;
}

std::string rendered_captures() {
  struct Scene {
    const char* name;
    Asked lights, normals, height;
  };
  const std::vector<Scene> scenes{
      {"paper_wrinkled", {0.3, 0.1}, {0.3, 0.1}, {0.01, 0.003}},
      {"paper_creased", {0.5, 0.3}, {0.3, 0.05}, {0.01, 0.001}},
      {"paper_glossy_printed", {1.0, 0.3}, {1.5, 1.0}, {0.25, 0.1}},
      {"cloth_rough", {0.8, 0.4}, {2.9, 2.0}, {0.09, 0.05}},
      {"near_light", {1.0, 0.3}, {1.0, 0.2}, {0.02, 0.003}},
  };
  const fs::path data = hada::data_folder() / "rendered";
  std::string page = table(
      "Captures by an independent renderer: measured (must / goal)",
      "| scene | boxes | spheres found / there / false | lights, mean deg | normals, mean deg "
      "| height, rms over std |");
  if (!fs::exists(data)) return page + row({"all", "", "not here: skipped", "", "", ""});
  for (const Scene& scene : scenes) {
    for (const auto boxes : {hada::Boxes::none, hada::Boxes::given}) {
      say(scene.name);
      const auto score = hada::rendered(data / scene.name, boxes);
      page += row({scene.name, boxes == hada::Boxes::none ? "none" : "given",
                   fmt::format("{} / {} / {}", score.spheres_found, score.spheres_true,
                               score.spheres_false),
                   judged(score.lights_deg, scene.lights, "{:.3f}"),
                   judged(score.normals_deg, scene.normals, "{:.3f}"),
                   judged(score.height_share, scene.height, "{:.4f}")});
    }
  }
  return page;
}

std::string light_intervals() {
  std::string page =
      table("Lights of virtual captures: one sphere of 80 px, eight lights, noise, 16 bits",
            "| sphere, lamps | median error | 90 % intervals hold the truth | must be | |");
  struct Case {
    const char* name;
    hada::LightStudyOptions options;
  };
  for (const Case& one : {Case{"matte, distant", {}}, Case{"chrome, distant", {.chrome = true}},
                          Case{"matte, 25 to 40 cm away", {.near = true}}}) {
    say(one.name);
    const auto study = hada::study_lights(one.options);
    page += row({one.name, fmt::format("{:.3f} deg", study.median_error_deg),
                 fmt::format("{:.1f} % of {}", 100.0 * study.coverage90, study.components),
                 "85 to 95 %", verdict(study.coverage90 >= 0.85 && study.coverage90 <= 0.95)});
  }
  return page;
}

// Every estimator on every scene whose normals are known, and how fast the common ones are.
std::string estimators() {
  const fs::path data = hada::data_folder();
  std::string heads = "| estimator |";
  std::vector<hada::NormalScene> scenes;
  for (const auto& name : hada::normal_scenes()) {
    const fs::path folder = name == "ball" ? data / "photos" : data / "rendered" / name;
    if (!fs::exists(folder)) continue;
    scenes.push_back(hada::normal_scene(data, name));
    heads += " " + name + " |";
  }
  std::string page = table("Normals under known lights, mean error in degrees", heads);
  std::vector<std::string> held{"adaptive, 90 % intervals hold the truth (85 to 95 %)"};
  for (const auto estimator : hada::every_estimator) {
    std::vector<std::string> cells{std::string(hada::name_of(estimator))};
    for (const auto& scene : scenes) {
      say(fmt::format("{} by {}", scene.name, cells[0]));
      const auto score = hada::normal_score(scene, estimator);
      cells.push_back(fmt::format("{:.3f}", score.mean_deg));
      if (estimator == hada::default_estimator) {
        held.push_back(fmt::format("{:.0f} %", 100.0 * score.within_90));
      }
    }
    page += row(cells);
  }
  std::vector<std::string> cells{"adaptive, lights off by 0.5 deg and 1 %"};
  for (const auto& scene : scenes) {
    const auto wrong = hada::with_errors_of_lights(scene, 0.5, 0.01, 1);
    cells.push_back(
        fmt::format("{:.3f}", hada::normal_score(wrong, hada::default_estimator).mean_deg));
  }
  page += row(cells) + row(held);
  page += table("Speed of normals: 12 grey lights, 4096 x 4096, in memory, ns per pixel and thread",
                "| estimator | must be | normals, albedo, mask | | with the sigmas | plain read |");
  for (const auto& speed :
       hada::normal_speed({hada::Estimator::least_squares, hada::Estimator::trimmed,
                           hada::Estimator::biweight, hada::Estimator::adaptive},
                          {.uncertainty = true})) {
    const double most = speed.estimator == hada::Estimator::least_squares ? 3.0
                        : speed.estimator == hada::default_estimator      ? 20.0
                                                                          : 0.0;
    page += row(
        {std::string(hada::name_of(speed.estimator)), most > 0.0 ? fmt::format("<= {}", most) : "",
         fmt::format("{:.1f}", speed.nanoseconds),
         most > 0.0 ? hada::verdict(speed.nanoseconds <= most) : "",
         fmt::format("{:.1f}", speed.with_uncertainty), fmt::format("{:.1f}", speed.plain_read)});
  }
  return page;
}

std::string depth_from_normals() {
  const fs::path data = hada::data_folder();
  std::string page =
      table("Depth from scanned normals: four DiLiGenT objects, perspective, jumps automatic",
            "| object | published, bilateral and plain | mean absolute error | | chosen |");
  if (!fs::exists(data / "normals_to_depth")) {
    return page + row({"all", "", "not here: skipped", "", ""});
  }
  struct Published {
    const char* object;
    double bilateral_mm;
    double plain_mm;
  };
  double mean = 0.0;
  for (const Published& p :
       {Published{"bear", 0.334, 0.138}, Published{"cat", 0.074, 2.124},
        Published{"goblet", 9.018, 8.922}, Published{"reading", 0.257, 2.837}}) {
    say(p.object);
    const auto score = hada::normals_to_depth(data, p.object);
    mean += score.error_mm / 4.0;
    page += row({p.object, fmt::format("{:.3f}, {:.3f} mm", p.bilateral_mm, p.plain_mm),
                 fmt::format("{:.3f} mm", score.error_mm),
                 verdict(score.error_mm <= std::min(p.bilateral_mm, p.plain_mm)),
                 score.may_jump ? "edge-aware" : "least squares"});
  }
  return page + fmt::format("\nMean of the four: {:.2f} mm.\n", mean);
}

std::string program() {
  say("the program itself");
  std::vector<double> seconds, memory;
  for (int i = 0; i < 25; ++i) {
    const auto cost = hada::run_process(HADA_PROGRAM, {"--help"});
    seconds.push_back(1000.0 * cost.seconds);
    memory.push_back(cost.megabytes);
  }
  const fs::path folder = fs::temp_directory_path() / "hada_results";
  fs::remove_all(folder);
  std::vector<double> demo;
  bool finished = true;
  for (const char* threads : {"1", "2"}) {
    const auto cost = hada::run_process(
        HADA_PROGRAM, {"demo", "-o", (folder / threads / "demo").string(), "--threads", threads});
    finished = finished && cost.exit_code == 0;
    demo.push_back(cost.seconds);
  }
  const bool same = finished && hada::same_bytes(folder / "1", folder / "2");
  fs::remove_all(folder);
  std::string page =
      table("The program", "| figure | must be | measured | |") +
      row({"`hada --help`", "<= 20 ms, <= 30 MB",
           fmt::format("{:.1f} ms, {:.1f} MB (medians of 25)", median(seconds), median(memory)),
           verdict(median(seconds) <= 20.0 && median(memory) <= 30.0)}) +
      row({"`hada demo` on 1 and on 2 threads", "the same bytes",
           same ? "the same bytes in every file" : "different", verdict(same)}) +
      row({"`hada demo`, from nothing to the report", "",
           fmt::format("{:.1f} s on 1 thread, {:.1f} s on 2", demo[0], demo[1]), ""});
  std::ifstream in(fs::path(HADA_BINARY_DIR) / "test_seconds.txt");
  double test_seconds = 0.0;
  if (in >> test_seconds) {
    page +=
        row({"`./test.sh` from a fresh clone, packages installed", "<= 15 min",
             fmt::format("{:.1f} min", test_seconds / 60.0), verdict(test_seconds <= 15.0 * 60.0)});
  }
  return page;
}

std::string text_of(const char* path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

// hada_results FILE.md [part ...]: measures all parts, or those named, and keeps the others as they
// stand in the file.
int main(int argc, char** argv) {
  // The program itself first, while this process is small: a child's memory counts its parent's.
  const std::vector<std::pair<std::string, std::string (*)()>> parts{
      {"program", program},
      {"real", real_photographs},
      {"rendered", rendered_captures},
      {"lights", light_intervals},
      {"normals", estimators},
      {"virtual", hada::virtual_captures},
      {"loop", hada::closed_loop},
      {"depth", depth_from_normals},
      {"height", hada::height_results},
      {"wrinkle", hada::wrinkle_results},
      {"ridges", hada::ridge_results},
      {"fold", hada::fold_results},
      {"forged", hada::forged_results},
      {"knit", [] { return hada::knit_results(hada::data_folder()); }},
      {"studio",
       [] { return hada::studio_results(fs::path(HADA_BINARY_DIR) / "studio_figures.json"); }},
      {"wood", [] { return hada::wood_results(hada::data_folder()); }}};
  if (argc < 2) {
    std::fprintf(stderr, "usage: hada_results FILE.md [part ...]; parts:");
    for (const auto& [name, measure] : parts) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  const std::vector<std::string> asked(argv + 2, argv + argc);
  std::string page =
      "# Results\n\nWritten by `cmake --build build --target results`; do not edit. Times are of "
      "the machine it ran on, errors are not.\n";
  if (!asked.empty()) page = text_of(argv[1]);
  for (const auto& [name, measure] : parts) {
    if (!asked.empty() && std::find(asked.begin(), asked.end(), name) == asked.end()) continue;
    page = hada::with_sections(std::move(page), measure());
    std::ofstream(argv[1]) << page;  // what is measured is kept
  }
  return 0;
}
