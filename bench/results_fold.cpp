#include "bench/results_fold.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "bench/accuracy.h"
#include "bench/crease_study.h"
#include "bench/fold_motion_study.h"
#include "bench/fold_study.h"
#include "bench/recorded_folds.h"
#include "bench/rendered_creases.h"
#include "bench/results_page.h"

namespace hada {
namespace {

std::string patterns(const std::filesystem::path& data) {
  std::string page =
      table("Folded paper: crease patterns, beside published counts and shapes",
            "| pattern | faces | states | published | geometry, of the sheet | time | |");
  for (const auto& score : score_patterns(data)) {
    double most_ms = 500.0;
    if (score.name.starts_with("042")) most_ms = 50.0;
    if (score.name.starts_with("032")) most_ms = 150.0;
    const bool met = score.states == score.states_published && score.geometry_error <= 1e-9 &&
                     score.milliseconds <= most_ms;
    page += row({score.name, std::to_string(score.faces), score.states, score.states_published,
                 fmt::format("{:.0e}", score.geometry_error),
                 fmt::format("{:.1f} ms", score.milliseconds), verdict(met)});
  }
  for (const auto& rejection : score_unfoldable(data)) {
    page += row(
        {rejection.name, "", "0", "0", rejection.reason, "", verdict(!rejection.reason.empty())});
  }
  return page;
}

std::string motion(const std::filesystem::path& data) {
  std::string page = table("Folded paper: motion and creases", "| figure | must be | measured | |");
  for (const auto& speed : spring_speeds()) {
    page += row({"springs, " + speed.name, ">= 2e7 faces x steps / s",
                 fmt::format("{:.1e}", speed.faces_steps_per_second),
                 verdict(speed.faces_steps_per_second >= 2e7)});
  }
  for (const auto& score : exact_scores()) {
    const double most_ms = score.faces <= 150 ? 20.0 : 50.0;
    page += row({fmt::format("made rigid again, {} faces", score.faces),
                 fmt::format("strain 1e-9, planarity 1e-5, {:.0f} ms", most_ms),
                 fmt::format("{:.0e}, {:.0e}, {:.1f} ms", score.strain, score.planarity,
                             score.milliseconds),
                 verdict(score.strain <= 1e-9 && score.planarity <= 1e-5 &&
                         score.milliseconds <= most_ms)});
  }
  const double miura = miura_error_deg();
  page += row({"Miura angles against the closed form", "<= 0.01 deg",
               fmt::format("{:.1e} deg", miura), verdict(miura <= 0.01)});
  for (const RecordedFold& fold : recorded_folds()) {
    page +=
        row({fmt::format("log of the {}: {} steps, {} faces", fold.title, fold.steps, fold.faces),
             "same bits again, 0 pairs pierce, layers in order",
             fmt::format("{}, {}, in {} of {} flat states", fold.same ? "same" : "not the same",
                         fold.piercing, fold.ordered_states, fold.flat_states),
             verdict(fold.same && fold.piercing == 0 && fold.contacts == 0 &&
                     fold.ordered_states == fold.flat_states)});
  }
  if (std::filesystem::exists(data / "fold")) {
    double worst = 0.0;
    for (const auto& score : driven_scores(data)) worst = std::max(worst, score.error);
    page += row({"sheets driven by another simulator, -100 to 100 %", "<= 1e-3 of the sheet",
                 fmt::format("{:.0e}", worst), verdict(worst <= 1e-3)});
  }
  const auto scene = data / "rendered" / "paper_creased";
  if (std::filesystem::exists(scene)) {
    const RenderedCreases found = rendered_creases(scene);
    page += row({"creases of a rendered sheet from its pictures", "<= 0.1 deg, <= 0.5 px",
                 fmt::format("{:.3f} deg, {:.2f} px, {} of {} found", found.worst_deg,
                             found.worst_line_px, found.found, found.creases),
                 verdict(found.worst_deg <= 0.1 && found.worst_line_px <= 0.5 &&
                         found.found == found.creases)});
  }
  const auto creases = study_creases({.sheets = 20});
  page += row(
      {"fold angles of 4 to 35 deg from 12 pictures, paper rough by 3 deg, lights wrong by 1 deg",
       "<= 0.2 deg rms",
       fmt::format("{:.3f} deg rms, {} of {} found, lines {:.2f} px rms", creases.rms_deg,
                   creases.found, creases.creases, creases.line_rms_px),
       verdict(creases.rms_deg <= 0.2 && creases.found == creases.creases)});
  const auto shallow = study_creases({.fold_low_deg = 2.0, .fold_high_deg = 2.5});
  page += row({"folds of 2 to 2.5 deg", "all found",
               fmt::format("{} of {}", shallow.found, shallow.creases),
               verdict(shallow.found == shallow.creases)});
  return page;
}

}  // namespace

std::string fold_results() {
  const std::filesystem::path data = data_folder();
  std::string page;
  if (std::filesystem::exists(data / "fold")) page += patterns(data);
  return page + motion(data);
}

}  // namespace hada
