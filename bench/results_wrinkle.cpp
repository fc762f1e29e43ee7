#include "bench/results_wrinkle.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include "bench/accuracy.h"
#include "bench/paper_study.h"
#include "bench/results_page.h"
#include "bench/texture_study.h"
#include "bench/wrinkle_study.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "measure/bands.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// What the median error of a field must be at most, in percent or degrees, of the large, the
/// middle and the small noise function.
double must_of(const std::string& path) {
  constexpr double amplitude[] = {3.5, 1.5, 0.5}, length[] = {4.0, 1.3, 0.3};
  constexpr double angle[] = {1.3, 0.4, 0.06};
  const auto k = std::size_t(path[path.find('[') + 1] - '0');
  if (path.ends_with("amplitude_mm")) return amplitude[k];
  return path.ends_with("angle_rad") ? angle[k] : length[k];
}

std::string wrinkle_fits() {
  std::string page =
      table("Wrinkle parameters: 40 maps of 512 x 512, three components",
            "| maps | parameter | median error | must be | | bound: 0.6745 sigma of Cramer and Rao "
            "| 95 % intervals hold the truth |");
  std::string ends;
  for (const double noise_mm : {0.003, 0.0}) {
    std::fprintf(stderr, "wrinkle fits, noise %g mm\n", noise_mm);
    const std::string maps = fmt::format("noise {} mm", noise_mm);
    const auto score = study_wrinkles({.components = 3, .noise_mm = noise_mm});
    for (const auto& field : score.fields) {
      constexpr double quartile = 0.6745;  // the median of the size of a normal number
      const bool angle = field.path.find("angle") != std::string::npos;
      const double unit = angle ? 1.0 : 100.0, error = unit * field.median_error;
      const char* name = angle ? "deg" : "%";
      page += row({maps, field.path, fmt::format("{:.2f} {}", error, name),
                   fmt::format("<= {} {}", must_of(field.path), name),
                   verdict(error <= must_of(field.path)),
                   fmt::format("{:.2f} {}", unit * quartile * field.median_sigma, name),
                   fmt::format("{:.0f} %", 100.0 * field.coverage)});
    }
    ends += fmt::format(
        "\n{}: 95 % intervals hold the truth in {:.1f} % of all (must be 93 to 97 %): {}.\n", maps,
        100.0 * score.coverage, verdict(score.coverage >= 0.93 && score.coverage <= 0.97));
  }
  return page + ends +
         "\nThe bound is the median error that no estimator without bias can beat, from the Fisher "
         "information of the periodogram: where a must lies below it, no fit of one map meets "
         "it.\n";
}

std::string wrinkle_speed() {
  std::fprintf(stderr, "speed of fits and synthesis\n");
  const double fit = wrinkle_fit_seconds(7), synthesis = synthesis_seconds(4096, 3);
  const double count = study_component_count(40);
  return table("Wrinkles: speed and number of components", "| figure | must be | measured | |") +
         row({"fit of 512 x 512, three components, one thread", "<= 0.5 s",
              fmt::format("{:.2f} s of processor time", fit), verdict(fit <= 0.5)}) +
         row({"synthesis of 4096 x 4096 with normals, one thread", "<= 1.0 s",
              fmt::format("{:.2f} s of processor time", synthesis), verdict(synthesis <= 1.0)}) +
         row({"number of components found, 1 to 4 true, 40 maps", ">= 95 %",
              fmt::format("{:.0f} %", 100.0 * count), verdict(count >= 0.95)});
}

std::string papers() {
  std::fprintf(stderr, "seven papers\n");
  std::string page = table("Seven papers: 10 sheets of each, turned, differing, with noise",
                           "| paper | named right | mean probability of the true paper |");
  double all = 0.0;
  const auto scores = study_papers(10);
  for (const auto& score : scores) {
    page += row({score.name, fmt::format("{:.0f} %", 100.0 * score.named_right),
                 fmt::format("{:.0f} %", 100.0 * score.mean_probability)});
    all += score.named_right / double(scores.size());
  }
  return page + fmt::format("\nNamed right in {:.1f} % of all (must be 95 %): {}.\n", 100.0 * all,
                            verdict(all >= 0.95));
}

// The band that is nearest to a true wavelength.
const Band* nearest(const std::vector<Band>& bands, double wavelength) {
  const Band* best = nullptr;
  for (const Band& band : bands) {
    if (!best || std::abs(std::log(band.wavelength / wavelength)) <
                     std::abs(std::log(best->wavelength / wavelength))) {
      best = &band;
    }
  }
  return best;
}

std::string bands_of_papers() {
  std::string page =
      table("Bands of the rendered papers, on their true heights",
            "| sheet | wave | wavelength, against the realised one | direction | rms |");
  for (const char* scene : {"paper_wrinkled", "paper_glossy_printed", "near_light"}) {
    const auto folder = data_folder() / "rendered" / scene / "truth";
    if (!std::filesystem::exists(folder)) {
      page += row({scene, "not here: skipped", "", "", ""});
      continue;
    }
    std::fprintf(stderr, "bands of %s\n", scene);
    std::ifstream in(folder / "truth.json");
    const Json truth = Json::parse(in);
    const double pitch = truth["camera"]["pixel_mm_at_mean_sheet_height"];
    const Surface sheet = read_surface(folder / "height_mm.exr", pitch);
    const auto found =
        bands(power_spectrum(sheet.height, sheet.mask, sheet.extent), sheet.height, sheet.mask);
    for (const Json& wave : truth["components"]) {
      const double wavelength = wave["realised_centroid_wavelength_mm"];
      const double rms = wave["realised_rms_mm"];
      const double direction = double(wave["realised_wavevector_deg_image"]) * degree;
      const bool has_direction = double(wave["realised_anisotropy_0to1"]) > 0.3;
      const Band* band = nearest(found, wavelength);
      if (!band) continue;
      page += row(
          {scene, fmt::format("{:.1f} mm", wavelength),
           fmt::format("{:+.1f} %", 100.0 * (band->wavelength / wavelength - 1.0)),
           has_direction
               ? fmt::format("{:+.1f} deg",
                             std::remainder(band->direction - direction, std::numbers::pi) / degree)
               : "none",
           fmt::format("{:+.1f} %", 100.0 * (band->rms / rms - 1.0))});
    }
  }
  return page;
}

std::string textures() {
  std::string page = table("Micro-textures made again with at most 5 noise functions",
                           "| picture | distance of the spectra | its floor: phases drawn anew | "
                           "within 0.6 dB | deviation, made over measured |");
  struct Piece {
    const char* name;
    int side;  // of the square in the upper left corner; 0: the whole picture
  };
  for (const auto& [name, side] :
       {Piece{"fabric_2004", 0}, Piece{"IMG_9877", 0}, Piece{"wood1008_sq512", 0},
        Piece{"fabric_2004", 64}, Piece{"fabric_2004", 112}, Piece{"wood1008_sq512", 192},
        Piece{"wood1008_sq512", 256}}) {
    const auto path = data_folder() / "wrinkle" / (std::string(name) + ".png");
    if (!std::filesystem::exists(path)) {
      page += row({name, "not here: skipped", "", "", ""});
      continue;
    }
    std::fprintf(stderr, "texture %s\n", name);
    const Surface picture = read_surface(path, 0.1);
    const TextureScore score =
        study_texture(side > 0 ? piece_of(picture, {0, 0, side, side}) : picture, 5);
    page +=
        row({side > 0 ? fmt::format("{}, {} px of it", name, side) : name,
             fmt::format("{:.2f} dB", score.distance_db), fmt::format("{:.2f} dB", score.floor_db),
             verdict(score.distance_db <= score.floor_db + 0.6),
             fmt::format("{:.2f}", score.std_ratio)});
  }
  return page;
}

}  // namespace

std::string wrinkle_results() {
  std::string page = wrinkle_fits();
  page += wrinkle_speed();
  page += papers();
  page += bands_of_papers();
  page += textures();
  return page;
}

}  // namespace hada
