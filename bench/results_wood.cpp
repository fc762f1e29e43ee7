#include "bench/results_wood.h"

#include <fmt/format.h>

#include "bench/block_study.h"
#include "bench/figure_study.h"
#include "bench/recorded_wood.h"
#include "bench/results_page.h"
#include "bench/wood_study.h"

namespace hada {
namespace {

constexpr int seeds = 200, vessel_seeds = 12, figure_seeds = 8, interlock_seeds = 60;

std::string rendered_rows(const std::filesystem::path& folder) {
  std::string page;
  for (const char* name : {"softwood_a", "ringporous_b"}) {
    const auto s = score_block(folder, name);
    const bool inside = std::string(name) == "softwood_a";
    page += row({fmt::format("rendered {}: pith, mm", name), inside ? "0.3" : "1.5",
                 fmt::format("{:.4f}", s.pith_mm), verdict(s.pith_mm <= (inside ? 0.3 : 1.5))});
    page += row({"its ring radii: mean error, mm", "0.05", fmt::format("{:.4f}", s.radii_mm),
                 verdict(s.radii_mm <= 0.05)});
    page += row({"its rings: recall, precision", "0.98, 0.95",
                 fmt::format("{:.3f}, {:.3f}", s.recall, s.precision),
                 verdict(s.recall >= 0.98 && s.precision >= 0.95)});
    page += row({"its spiral grain, deg", "0.3", fmt::format("{:.2f}", s.spiral_deg),
                 verdict(s.spiral_deg <= 0.3)});
  }
  return page;
}

std::string disc_rows(const std::filesystem::path& folder) {
  const auto s = score_disc(folder);
  return row({"disc F02b: pith, % of its radius", "1", fmt::format("{:.2f}", 100.0 * s.pith_share),
              verdict(s.pith_share <= 0.01)}) +
         row({"its rings within 6 px of CS-TRD's", "21 of 21",
              fmt::format("{} of {}", s.found, s.rings), verdict(s.found == s.rings)}) +
         row({"of those that CS-TRD followed, not interpolated between others", "all",
              fmt::format("{} of {}", s.followed_found, s.followed),
              verdict(s.followed_found == s.followed)}) +
         row({"median difference of mean radii, px", "0.5", fmt::format("{:.2f}", s.radius_px),
              verdict(s.radius_px <= 0.5)}) +
         row({"seconds of a core", "3", fmt::format("{:.1f}", s.seconds),
              verdict(s.seconds <= 3.0)});
}

std::string solid_rows(const std::filesystem::path& folder) {
  std::string page;
  for (const char* name : {"softwood_a", "ringporous_b"}) {
    const auto s = score_solid(folder, name);
    page += row({fmt::format("rendered {} as a block: lean, taper", name), "",
                 fmt::format("off by {:.5f}, {:.5f}", s.lean, s.taper), ""});
    page += row({"its ring lines on a slanted cut that is not seen: median error, mm", "",
                 fmt::format("{:.3f}", s.line_mm), ""});
    page += row({"their 90 % bands hold, %", "", fmt::format("{:.0f}", 100.0 * s.coverage), ""});
  }
  return page;
}

std::string left_out_rows(const std::filesystem::path& folder) {
  std::string page;
  double c = 0.0, e = 0.0;
  for (const auto& s : left_out_faces(folder)) {
    page +=
        row({fmt::format("CN03 without {}: its ring lines, px (of a ring); in the band, %", s.face),
             "measured",
             fmt::format("{:.1f} ({:.2f}); {:.0f}", s.error, s.width, 100.0 * s.coverage), ""});
    if (!s.has_slope) continue;
    page +=
        row({"the slope of its fibres: seen, predicted", "measured",
             fmt::format("{:.3f}, {:.3f} ± {:.3f}", s.slope, s.expected, s.expected_sigma), ""});
    if (s.face == "C") c = s.slope;
    if (s.face == "E") e = s.slope;
  }
  const double mean = 0.5 * (std::abs(c) + std::abs(e));
  const double apart = mean > 0.0 ? std::abs(c + e) / mean : 1.0;
  return page + row({"CN03: mean slope of faces C and E, mirrored within", "10 %",
                     fmt::format("{:.3f}, {:.3f}: {:.1f} %", c, e, 100.0 * apart),
                     verdict(c * e < 0.0 && apart <= 0.1)});
}

// Of 90 % intervals.
bool within(double share) {
  return share >= 0.85 && share <= 0.95;
}

std::string made_rows() {
  const auto s = study_stems(seeds);
  return row({fmt::format("{} made end grains: pith, % of the radius", seeds), "0.2",
              fmt::format("{:.4f}", 100.0 * s.pith_share), verdict(s.pith_share <= 0.002)}) +
         row({"their ring radii, px rms", "0.3", fmt::format("{:.3f}", s.radii_px),
              verdict(s.radii_px <= 0.3)}) +
         row({"their rings: F1", "0.99", fmt::format("{:.4f}", s.f1), verdict(s.f1 >= 0.99)}) +
         row({"their 90 % intervals: pith; lobes; radii; all, %", "all 85 to 95",
              fmt::format("{:.1f}; {:.1f}; {:.1f}; {:.1f}", 100.0 * s.pith_coverage,
                          100.0 * s.lobe_coverage, 100.0 * s.radii_coverage, 100.0 * s.coverage),
              verdict(within(s.coverage))}) +
         row({"made faces: fibre gradient", "0.01", fmt::format("{:.4f}", s.spiral),
              verdict(s.spiral <= 0.01)}) +
         row({"their wave amplitude, length, %", "2, 2",
              fmt::format("{:.2f}, {:.2f}", 100.0 * s.wave_amplitude, 100.0 * s.wave_length),
              verdict(s.wave_amplitude <= 0.02 && s.wave_length <= 0.02)}) +
         row({"their 90 % intervals: gradient; amplitude; length; all, %", "all 85 to 95",
              fmt::format("{:.1f}; {:.1f}; {:.1f}; {:.1f}", 100.0 * s.gradient_coverage,
                          100.0 * s.amplitude_coverage, 100.0 * s.length_coverage,
                          100.0 * s.face_coverage),
              verdict(within(s.face_coverage))});
}

std::string interlock_rows() {
  const auto s = study_interlock(interlock_seeds);
  return row({fmt::format("{} made faces of interlocked grain: told", interlock_seeds), "",
              fmt::format("{} of {}", s.told, s.faces), ""}) +
         row({"their period, median error, %", "5", fmt::format("{:.2f}", 100.0 * s.period),
              verdict(s.period <= 0.05)}) +
         row({"its 90 % intervals, %", "85 to 95", fmt::format("{:.0f}", 100.0 * s.coverage),
              verdict(within(s.coverage))});
}

std::string vessel_rows() {
  const auto s = study_vessels(vessel_seeds);
  return row({fmt::format("vessels of {} made woods: density, radius, median error, %", s.woods),
              "5, 5", fmt::format("{:.1f}, {:.1f}", 100.0 * s.density, 100.0 * s.radius),
              verdict(s.density <= 0.05 && s.radius <= 0.05)}) +
         row({"their porosity told right", "all", fmt::format("{} of {}", s.right, s.woods),
              verdict(s.right == s.woods)}) +
         row({"their 90 % intervals, %", "", fmt::format("{:.0f}", 100.0 * s.coverage), ""});
}

std::string figure_rows() {
  const auto s = study_figures(figure_seeds);
  return row(
      {fmt::format("figure of {} boards, 9 lights, 1 % noise: gloss, sharpness, %; dive, deg",
                   figure_seeds),
       "2, 3; 0.7",
       fmt::format("{:.2f}, {:.2f}; {:.2f}", 100.0 * s.specular, 100.0 * s.sharpness, s.dive_deg),
       verdict(s.specular <= 0.02 && s.sharpness <= 0.03 && s.dive_deg <= 0.7)});
}

}  // namespace

std::string wood_results(const std::filesystem::path& data) {
  std::string page = table("Wood", "| figure | must be | measured | |");
  if (std::filesystem::exists(data / "rendered" / "wood_block"))
    page += rendered_rows(data / "rendered" / "wood_block") +
            solid_rows(data / "rendered" / "wood_block");
  if (std::filesystem::exists(data / "wood" / "block_CN03"))
    page += left_out_rows(data / "wood" / "block_CN03");
  if (std::filesystem::exists(data / "wood" / "disc")) page += disc_rows(data / "wood" / "disc");
  if (std::filesystem::exists(data / "wood" / "xray_profiles")) {
    const auto s = score_profiles(data / "wood" / "xray_profiles");
    page += row({"x-ray profiles within one ring of their years", "17 of 18",
                 fmt::format("{} of {}", s.right, s.dated), verdict(18 * s.right >= 17 * s.dated)});
  }
  page += made_rows() + interlock_rows() + vessel_rows() + figure_rows();
  const double seconds = seconds_of_a_slice();
  page += row({"2048 x 2048 wavy, ring-porous: seconds of a core", "1 (goal 0.25)",
               fmt::format("{:.2f}", seconds), verdict(seconds <= 1.0)});
  return page +
         "\nA ring ends where the rise to the light wood of the next begins, where that can be "
         "told "
         "from how sharp the picture is; else half way up, and bands of cuts allow for it.\n";
}

}  // namespace hada
