// hada_bench_forged [pictures] [ring_seeds]: how often the folds of steel are read back, and how
// fast it is made.
#include <cstdio>
#include <cstdlib>

#include "bench/forged_study.h"

int main(int count, char** words) {
  const int pictures = count > 1 ? std::atoi(words[1]) : 24;
  const int seeds = count > 2 ? std::atoi(words[2]) : 50;
  for (const char* sequence : {"CCCCCCCCCCCC", "CRCRCRCRCRCR"})
    std::printf("block of 2048 x 16384, %s: %.3f s of processor time\n", sequence,
                hada::block_processor_seconds(sequence, 3));
  std::fflush(stdout);
  const auto told = [&](const char* name, const hada::ForgedStudyOptions& options) {
    const auto s = hada::study_forged(options);
    std::printf(
        "%s: counts %.1f %%, sequence %.1f %%, among three %.1f %%, kind %.1f %%; of %d given "
        "0.4 to 0.6 %.0f %% right; %.2f s\n",
        name, 100.0 * s.counts, 100.0 * s.first, 100.0 * s.among_three, 100.0 * s.kinds, s.unsure,
        100.0 * s.unsure_right, s.seconds_median);
    std::fflush(stdout);
  };
  if (pictures > 0) {
    told("clean, 512 x 1024", {.pictures = pictures, .picture = hada::GrainPicture::clean});
    told("levels, 512 x 1024, 9 folds, length unknown", {.pictures = pictures,
                                                         .folds = 9,
                                                         .length_known = false,
                                                         .picture = hada::GrainPicture::made});
    told("photographed, 512 x 1024", {.pictures = pictures});
    told("photographed, 512 x 1024, length unknown", {.pictures = pictures, .length_known = false});
    told("photographed, 256 x 256", {.pictures = 2 * pictures, .rows = 256, .cols = 256});
    told("photographed, 128 x 128", {.pictures = 2 * pictures, .rows = 128, .cols = 128});
  }
  if (seeds > 1) {
    for (const auto& grain : hada::paper_grains()) {
      if (grain.seed != 0) continue;
      const auto rings = hada::grain_rings(grain.sequence, seeds);
      std::printf(
          "%s: %d of %d rings within 2 sigma of the closed form, %d within %.2f; sigma %.4f, worst "
          "ratio %.4f\n",
          rings.sequence.c_str(), rings.within_two_sigma, rings.rings, rings.within_sampling,
          hada::ring_sampling_sigmas, rings.sigma_median, rings.worst_ratio);
      std::fflush(stdout);
    }
  }
}
