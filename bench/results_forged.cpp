#include "bench/results_forged.h"

#include <fmt/format.h>

#include "bench/forged_study.h"
#include "bench/results_page.h"

namespace hada {
namespace {

constexpr int pictures = 24;
constexpr int turned_pictures = 8;  // they take longer
constexpr int tiny_pictures = 100;  // so small that one in three leaves two sequences
constexpr int seeds = 200;

std::string share(double value) {
  return fmt::format("{:.0f} %", 100.0 * value);
}

std::string named_rows() {
  const auto clean = study_forged({.pictures = pictures, .picture = GrainPicture::clean});
  std::string page = row({"clean crop of 512 x 1024, 6 folds: whole sequence first", "99 %",
                          share(clean.first), verdict(clean.first >= 0.99)});
  const auto made = study_forged(
      {.pictures = pictures, .folds = 9, .length_known = false, .picture = GrainPicture::made});
  page += row({"levels 70 / 5 and no more, 9 folds of 2 to 12 possible: first, among three", "",
               share(made.first) + ", " + share(made.among_three), ""});
  const auto seen = study_forged({.pictures = pictures});
  page += row({"levels 70 / 5, noise 10 %, blur 0.7 px, tone: number of C and of R", "95 %",
               share(seen.counts), verdict(seen.counts >= 0.95)});
  page += row({"its sequence: first, among three", "60 %, 90 %",
               share(seen.first) + ", " + share(seen.among_three),
               verdict(seen.first >= 0.6 && seen.among_three >= 0.9)});
  page += row({"masame, itame, mokume", "98 %", share(seen.kinds), verdict(seen.kinds >= 0.98)});
  const auto small = study_forged({.pictures = pictures, .rows = 256, .cols = 256});
  page += row({"the same, 256 x 256: among three", "75 %", share(small.among_three),
               verdict(small.among_three >= 0.75)});
  const auto turned =
      study_forged({.pictures = turned_pictures, .length_known = false, .turned = true});
  page +=
      row({fmt::format(
               "512 x 1024, turned by up to 4 deg, scaled by up to 16 %, 2 to 12 folds possible, "
               "{} pictures: first, among three",
               turned_pictures),
           "", share(turned.first) + ", " + share(turned.among_three), ""});
  const auto tiny = study_forged({.pictures = tiny_pictures, .rows = 128, .cols = 128});
  const int unsure = small.unsure + tiny.unsure;
  const double right =
      unsure > 0 ? (small.unsure * small.unsure_right + tiny.unsure * tiny.unsure_right) / unsure
                 : 0.0;
  return page + row({"sequences given 0.4 to 0.6, 256 x 256 and 128 x 128: right", "35 to 65 %",
                     fmt::format("{} of {}", share(right), unsure),
                     verdict(right >= 0.35 && right <= 0.65)});
}

std::string ring_rows() {
  std::string page;
  int within_two = 0, all = 0;
  for (const auto& grain : paper_grains()) {
    if (grain.seed != 0) continue;  // the other picture of the same sequence
    const auto rings = grain_rings(grain.sequence, seeds);
    page +=
        row({fmt::format("{}: rings of {} seeds that the closed form explains within sampling "
                         "error, {} sigma (sigma {:.1f} %)",
                         grain.sequence, seeds, ring_sampling_sigmas, 100.0 * rings.sigma_median),
             "95 %", fmt::format("{} of {}", rings.within_sampling, rings.rings),
             verdict(rings.within_sampling >= 0.95 * rings.rings)});
    within_two += rings.within_two_sigma;
    all += rings.rings;
  }
  return page + row({"rings of all seven within 2 sigma (exact: 95.4 %)", "95 %",
                     fmt::format("{} of {}", within_two, all), verdict(within_two >= 0.95 * all)});
}

}  // namespace

std::string forged_results() {
  const double seconds = block_processor_seconds("CRCRCRCRCRCR", 5);
  return table("Forged steel", "| figure | must | measured | met |") +
         row({"block of 2048 x 16384, 12 folds: processor time of 2 cores, s", "1.0",
              fmt::format("{:.2f}", seconds), verdict(seconds <= 1.0)}) +
         ring_rows() + named_rows();
}

}  // namespace hada
