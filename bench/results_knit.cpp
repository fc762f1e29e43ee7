#include "bench/results_knit.h"

#include <fmt/format.h>

#include "bench/knit_study.h"
#include "bench/knit_tracking_study.h"
#include "bench/results_page.h"

namespace hada {
namespace {

constexpr int seeds = 200;
constexpr int pictures = 12;
constexpr int photographs = 20;

std::string rest_rows() {
  const auto patch = study_patch();
  const double hundred = seconds_to_rest(100), three_hundred = seconds_to_rest(300);
  return row({"the paper's 10 x 10: steps until it moves by less than 1e-3 of the pitch",
              "about 100", fmt::format("{}", patch.steps),
              verdict(patch.steps >= 80 && patch.steps <= 120)}) +
         row({"Newton against the long explicit run, pitches", "1e-6",
              fmt::format("{:.0e}", patch.rest_apart), verdict(patch.rest_apart <= 1e-6)}) +
         row({"100 x 100 pulled to 1.5 to rest, s", "0.3", fmt::format("{:.2f}", hundred),
              verdict(hundred <= 0.3)}) +
         row({"300 x 300, s", "3 (goal 1)", fmt::format("{:.2f}", three_hundred),
              verdict(three_hundred <= 3.0)});
}

std::string worn_rows() {
  const auto s = study_wear(300);
  const auto stocking = study_stocking(150);
  return row({"300 x 300 on the leg: drawn, slid and repaired, s", "30 (goal 5)",
              fmt::format("{:.1f}", s.seconds), verdict(s.settled && s.seconds <= 30.0)}) +
         row({fmt::format("yarns inside the leg after the repair ({} before)", s.cut), "0",
              fmt::format("{}", s.penetrating), verdict(s.penetrating == 0)}) +
         row({"a stocking of 150 x 150 with heel and toe: drawn, slid and repaired, s", "at rest",
              fmt::format("{:.1f}", stocking.seconds), verdict(stocking.settled)}) +
         row({fmt::format("its yarns inside leg and foot ({} before)", stocking.cut), "0",
              fmt::format("{}", stocking.penetrating), verdict(stocking.penetrating == 0)});
}

std::string stiffness_rows() {
  const auto s = study_stiffness(seeds);
  return row({fmt::format(
                  "{} knits of 16 x 16 at 1.2 and 1.5, three-point clamps, 2 % noise: error "
                  "of the ratio 10, rms",
                  seeds),
              fmt::format("1.2 x the bound of {:.3f}", s.ratio_bound),
              fmt::format("{:.4f}", s.ratio_spread),
              verdict(s.ratio_spread <= 1.2 * s.ratio_bound)}) +
         row({"of the yarn coefficient 0.2",
              fmt::format("1.2 x the bound of {:.4f}", s.continuity_bound),
              fmt::format("{:.5f}", s.continuity_spread),
              verdict(s.continuity_spread <= 1.2 * s.continuity_bound)}) +
         row({"95 % intervals that hold the truth, %", "93 to 97",
              fmt::format("{:.1f}", 100.0 * s.coverage),
              verdict(s.coverage >= 0.93 && s.coverage <= 0.97)});
}

std::string identifiable(const StiffnessBounds& b) {
  constexpr double unknown = 1.0;
  const auto text = [](double sigma, const char* format) {
    return sigma > unknown ? std::string("nothing") : fmt::format(fmt::runtime(format), sigma);
  };
  return fmt::format("rank {}; {}, {}", b.rank, text(b.log_ratio, "{:.4f}"),
                     text(b.continuity, "{:.4f}"));
}

// What is known of (ln ratio, c) at best, which is no demand: it has no verdict.
std::string clamp_rows() {
  std::string page;
  for (const auto clamp : {KnitClamp::uniform, KnitClamp::three_points}) {
    for (const auto pull : {KnitPull::course, KnitPull::wale}) {
      page +=
          row({fmt::format("{} clamps, along the {}s: rank, sigma of ln ratio, of c at 2 % noise",
                           clamp == KnitClamp::uniform ? "uniform" : "three-point",
                           pull == KnitPull::course ? "course" : "wale"),
               clamp == KnitClamp::uniform ? "rank 1" : "rank 2",
               identifiable(clamp_bounds(pull, clamp)),
               verdict(clamp_bounds(pull, clamp).rank == (clamp == KnitClamp::uniform ? 1 : 2))});
    }
  }
  return page;
}

std::string tracking_rows() {
  const auto s = study_tracking(photographs);
  return row({fmt::format("{} made pairs of photographs, three-point clamps at 1.2 and 1.5: "
                          "crossings found",
                          s.trials),
              "all", fmt::format("{}", s.found), verdict(s.found == s.trials)}) +
         row({"a crossing tracked, each way: px, share of a wale (2 % was asked of positions)",
              "sub-pixel", fmt::format("{:.2f}, {:.4f}", s.off_px, s.off_wales),
              verdict(s.off_px < 0.5)}) +
         row({"ratio 10 from the photographs: error, rms; sigma as told", "within 1.3 sigma",
              fmt::format("{:.3f}; {:.3f}", s.ratio_error, s.ratio_sigma),
              verdict(s.ratio_error < 1.3 * s.ratio_sigma)}) +
         row({"yarn coefficient 0.2: error, rms; sigma as told", "within 1.3 sigma",
              fmt::format("{:.4f}; {:.4f}", s.continuity_error, s.continuity_sigma),
              verdict(s.continuity_error < 1.3 * s.continuity_sigma)}) +
         row({fmt::format("95 % intervals of both that hold the truth, % of {}", 2 * s.found),
              "85 to 100", fmt::format("{:.1f}", 100.0 * s.coverage), verdict(s.coverage >= 0.85)});
}

std::string lattice_rows() {
  const auto s = study_lattice(pictures);
  return row({fmt::format("{} made pictures: wale, course, % at most", pictures), "0.1 (goal 0.05)",
              fmt::format("{:.3f}, {:.3f}", 100.0 * s.wale, 100.0 * s.course),
              verdict(s.wale <= 1e-3 && s.course <= 1e-3)});
}

std::string rendered_rows(const std::filesystem::path& folder) {
  std::string page;
  for (const auto& s : score_rendered_knits(folder)) {
    page += row({fmt::format("rendered {}: wale, course, %", s.name), "0.2",
                 fmt::format("{:.3f}, {:.3f}", 100.0 * s.wale, 100.0 * s.course),
                 verdict(s.wale <= 2e-3 && s.course <= 2e-3)});
    page += row({"its rotation, deg", "0.05", fmt::format("{:.3f}", s.rotation_deg),
                 verdict(s.rotation_deg <= 0.05)});
    page += row({"its yarn radius, gradients, %", "5, 10",
                 fmt::format("{:.1f}, {:.1f}", 100.0 * s.radius, 100.0 * s.gradient),
                 verdict(s.radius <= 0.05 && s.gradient <= 0.1)});
    page += row({"its colour repeat", "exact", s.repeat ? "exact" : "wrong", verdict(s.repeat)});
  }
  return page;
}

std::string photograph_rows(const std::filesystem::path& folder) {
  std::string page;
  const auto hand = folder / "whichstitch_stockinette.jpg";
  if (std::filesystem::exists(hand)) {
    const auto [wales, courses] = count_hand_knit(hand);
    page += row({"hand knit photograph: wales x courses", "14.2 x 22.0 within 0.5 %",
                 fmt::format("{:.2f} x {:.2f}", wales, courses),
                 verdict(std::abs(wales / 14.2 - 1.0) <= 0.005 &&
                         std::abs(courses / 22.0 - 1.0) <= 0.005)});
  }
  const auto jersey = folder / "jersey_authored" / "Fabric_Knitted_006_height.png";
  if (std::filesystem::exists(jersey)) {
    const double error = jersey_peak_error(jersey);
    page += row({"authored jersey: peaks at (32, 64), (64, 0), cycles off", "exact",
                 fmt::format("{:.4f}", error), verdict(error < 0.005)});
  }
  return page;
}

}  // namespace

std::string knit_results(const std::filesystem::path& data) {
  std::string page = table("Knit", "| figure | must be | measured | |") + rest_rows() +
                     worn_rows() + stiffness_rows() + clamp_rows() + tracking_rows() +
                     lattice_rows();
  const auto rendered = data / "rendered" / "knit_flat";
  if (std::filesystem::exists(rendered)) page += rendered_rows(rendered);
  return page + photograph_rows(data / "knit");
}

}  // namespace hada
