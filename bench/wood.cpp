// hada_bench_wood DATA [seeds]: how well wood is read, beside truths and other programs, and how
// fast it is made.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bench/block_study.h"
#include "bench/recorded_wood.h"
#include "bench/wood_study.h"

int main(int count, char** words) {
  const std::filesystem::path data = count > 1 ? words[1] : "../shared/data";
  const int seeds = count > 2 ? std::atoi(words[2]) : 40;
  if (std::filesystem::exists(data / "rendered" / "wood_block")) {
    for (const char* name : {"softwood_a", "ringporous_b"}) {
      const auto s = hada::score_block(data / "rendered" / "wood_block", name);
      std::printf("%s: pith %.4f mm, radii %.4f mm, recall %.3f, precision %.3f, spiral %.2f deg\n",
                  name, s.pith_mm, s.radii_mm, s.recall, s.precision, s.spiral_deg);
    }
  }
  if (std::filesystem::exists(data / "wood" / "disc")) {
    const auto s = hada::score_disc(data / "wood" / "disc");
    std::printf(
        "disc F02b: pith %.2f %% of R, %d of %d rings within 6 px (%d of %d that were followed), "
        "radius %.2f px, %.1f s of a core\n",
        100.0 * s.pith_share, s.found, s.rings, s.followed_found, s.followed, s.radius_px,
        s.seconds);
  }
  for (const auto& s : hada::left_out_faces(data / "wood" / "block_CN03")) {
    std::printf(
        "CN03 without %s: %d places, lines %.1f px beside (%.2f of a ring), coverage %.0f %%",
        s.face.c_str(), s.places, s.error, s.width, 100.0 * s.coverage);
    if (s.has_slope)
      std::printf("; slope %.3f, predicted %.3f +- %.3f", s.slope, s.expected, s.expected_sigma);
    std::printf("\n");
  }
  for (const char* name : {"softwood_a", "ringporous_b"}) {
    if (!std::filesystem::exists(data / "rendered" / "wood_block")) break;
    const auto s = hada::score_solid(data / "rendered" / "wood_block", name);
    std::printf(
        "%s as a block: lean off by %.5f, taper by %.5f; slanted cut: lines %.3f mm beside, "
        "coverage %.0f %%\n",
        name, s.lean, s.taper, s.line_mm, 100.0 * s.coverage);
  }
  if (std::filesystem::exists(data / "wood" / "xray_profiles")) {
    const auto s = hada::score_profiles(data / "wood" / "xray_profiles");
    std::printf("x-ray profiles: %d of %d within one ring\n", s.right, s.dated);
  }
  std::printf("slice of 2048^2 pixels: %.2f s of one core\n", hada::seconds_of_a_slice());
  if (seeds < 1) return 0;
  const auto s = hada::study_stems(seeds);
  std::printf(
      "%d made stems: pith %.4f %% of R, radii %.3f px rms, F1 %.4f, coverage %.1f %% (pith %.1f, "
      "lobes %.1f, "
      "radii %.1f)\n",
      seeds, 100.0 * s.pith_share, s.radii_px, s.f1, 100.0 * s.coverage, 100.0 * s.pith_coverage,
      100.0 * s.lobe_coverage, 100.0 * s.radii_coverage);
  std::printf(
      "made faces: spiral %.4f, wave amplitude %.2f %%, length %.2f %%, coverage %.1f %% (%.1f, "
      "%.1f, %.1f)\n",
      s.spiral, 100.0 * s.wave_amplitude, 100.0 * s.wave_length, 100.0 * s.face_coverage,
      100.0 * s.gradient_coverage, 100.0 * s.amplitude_coverage, 100.0 * s.length_coverage);
  const auto i = hada::study_interlock(seeds);
  std::printf("interlocked faces: %d of %d told, period %.2f %%, coverage %.0f %%\n", i.told,
              i.faces, 100.0 * i.period, 100.0 * i.coverage);
  return 0;
}
