// hada_results FILE: measures every figure that the project claims and writes them as a page.
// Real data that is absent is said to be absent; nothing here is written by hand.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/accuracy.h"
#include "bench/normals_speed.h"
#include "bench/normals_study.h"
#include "bench/process.h"
#include "bench/wrinkle_study.h"

namespace {

namespace fs = std::filesystem;

std::string table(const std::string& title, const std::string& heads) {
  std::string rule = "|";
  for (const char c : heads) {
    if (c == '|') rule += " --- |";
  }
  rule.resize(rule.size() - 6);  // one more bar than columns
  return "\n## " + title + "\n\n" + heads + "\n" + rule + "\n";
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string verdict(bool met) {
  return met ? "met" : "**not met**";
}

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
  const fs::path data = hada::data_folder() / "rendered";
  std::string page = table("Captures by an independent renderer, no box given, default estimator",
                           "| scene | spheres found / there / false | lights, mean | normals, mean "
                           "| height, rms of std |");
  if (!fs::exists(data)) return page + row({"all", "not here: skipped", "", "", ""});
  for (const char* scene :
       {"paper_wrinkled", "paper_creased", "paper_glossy_printed", "cloth_rough", "near_light"}) {
    say(scene);
    const auto score = hada::rendered(data / scene);
    page += row(
        {scene,
         fmt::format("{} / {} / {}", score.spheres_found, score.spheres_true, score.spheres_false),
         fmt::format("{:.2f} deg", score.lights_deg), fmt::format("{:.2f} deg", score.normals_deg),
         fmt::format("{:.1f} %", 100.0 * score.height_share)});
  }
  return page +
         "\nThe lights of near_light stand 40 cm away and are taken as distant here; the printed "
         "sheet is glossy.\n";
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
  for (const auto estimator : hada::every_estimator) {
    std::vector<std::string> cells{std::string(hada::name_of(estimator))};
    for (const auto& scene : scenes) {
      say(fmt::format("{} by {}", scene.name, cells[0]));
      cells.push_back(fmt::format("{:.3f}", hada::normal_score(scene, estimator).mean_deg));
    }
    page += row(cells);
  }
  std::vector<std::string> cells{"adaptive, lights off by 0.5 deg and 1 %"};
  for (const auto& scene : scenes) {
    const auto wrong = hada::with_errors_of_lights(scene, 0.5, 0.01, 1);
    cells.push_back(
        fmt::format("{:.3f}", hada::normal_score(wrong, hada::default_estimator).mean_deg));
  }
  page += row(cells);
  page += table("Speed of normals: 12 grey lights, 4096 x 4096, in memory, ns per pixel and thread",
                "| estimator | goal | normals, albedo, mask | with the sigmas | plain read |");
  for (const auto& speed :
       hada::normal_speed({hada::Estimator::least_squares, hada::Estimator::trimmed,
                           hada::Estimator::biweight, hada::Estimator::adaptive},
                          {.uncertainty = true})) {
    const char* goal = speed.estimator == hada::Estimator::least_squares ? "<= 3"
                       : speed.estimator == hada::default_estimator      ? "<= 20"
                                                                         : "";
    page += row({std::string(hada::name_of(speed.estimator)), goal,
                 fmt::format("{:.1f}", speed.nanoseconds),
                 fmt::format("{:.1f}", speed.with_uncertainty),
                 fmt::format("{:.1f}", speed.plain_read)});
  }
  return page;
}

std::string virtual_captures() {
  std::vector<double> lights, normals, heights;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    say(fmt::format("virtual capture {}", seed));
    const auto score = hada::synthetic_loop(seed);
    lights.push_back(score.lights_deg);
    normals.push_back(score.normals_deg);
    heights.push_back(100.0 * score.height_share);
  }
  const auto text = [](const std::vector<double>& v, const char* unit) {
    return fmt::format("{:.2f} {} median, {:.2f} worst of {}", median(v), unit,
                       *std::max_element(v.begin(), v.end()), v.size());
  };
  const auto worst = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end());
  };
  return table("Virtual captures: rendered 4 times finer, noise, 16 bits",
               "| figure | must be | measured | |") +
         row({"lights", "<= 0.3 deg mean", text(lights, "deg"), verdict(worst(lights) <= 0.3)}) +
         row({"normals", "<= 1.0 deg mean", text(normals, "deg"), verdict(worst(normals) <= 1.0)}) +
         row({"height, rms error over its standard deviation", "<= 2 %", text(heights, "%"),
              verdict(worst(heights) <= 2.0)});
}

std::string wrinkle_fits() {
  std::string page = table("Wrinkle parameters: 40 maps of 512 x 512, three components",
                           "| maps | parameter | median error | 95 % intervals hold the truth |");
  std::string ends;
  for (const double noise_mm : {0.003, 0.0}) {
    say(fmt::format("wrinkle fits, noise {} mm", noise_mm));
    const std::string maps = fmt::format("noise {} mm", noise_mm);
    const auto score = hada::study_wrinkles({.components = 3, .noise_mm = noise_mm});
    bool met = score.coverage >= 0.90 && score.coverage <= 0.98;
    for (const auto& field : score.fields) {
      const bool angle = field.path.find("angle") != std::string::npos;
      met = met && (angle ? field.median_error <= 1.5 : field.median_error <= 0.05);
      page += row({maps, field.path,
                   angle ? fmt::format("{:.2f} deg", field.median_error)
                         : fmt::format("{:.2f} %", 100.0 * field.median_error),
                   fmt::format("{:.0f} %", 100.0 * field.coverage)});
    }
    ends += fmt::format(
        "\n{}: 95 % intervals hold the truth in {:.1f} % of all; a fit takes {:.2f} s. Amplitude "
        "and "
        "lengths within 5 %, angle within 1.5 deg, coverage 90 to 98 %: {}.\n",
        maps, 100.0 * score.coverage, score.seconds_median, verdict(met));
  }
  return page + ends;
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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: hada_results FILE.md\n");
    return 2;
  }
  std::string page =
      "# Results\n\nWritten by `cmake --build build --target results`; do not edit. Times are of "
      "the "
      "machine it ran on, errors are not.\n";
  // First, while this process is small: a child's memory is counted from its parent's.
  const std::string of_program = program();
  page += real_photographs();
  page += rendered_captures();
  page += estimators();
  page += virtual_captures();
  page += wrinkle_fits();
  page += of_program;
  std::ofstream(argv[1]) << page;
  return 0;
}
