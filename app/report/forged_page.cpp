#include "app/report/forged_page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/draw/maps.h"
#include "app/report/figure.h"
#include "app/report/html.h"

namespace hada {
namespace {

constexpr int most_px = 512;  // of the side of a picture
constexpr int spectrum_px = 320;
constexpr std::size_t most_sequences = 12;
constexpr double least_share = 0.001;  // of a sequence that has a row of its own
constexpr Seed sample_seed = 1;
constexpr int rim_rows = 1024, rim_cols = 8192;  // of a block, felt after up to 12 folds

/// The middle of the brightness, no side longer than `most_px`.
Grid<float> shown_part(const Surface& surface) {
  const Grid<float> all = surface.albedo.empty() ? surface.height : luminance(surface.albedo);
  const int rows = std::min(all.rows(), most_px), cols = std::min(all.cols(), most_px);
  return crop(all, (all.rows() - rows) / 2, (all.cols() - cols) / 2, rows, cols);
}

/// The same order of values as in `sample`, the values themselves those of `picture`.
Grid<float> with_the_tone_of(const Grid<float>& picture, Grid<float> sample) {
  std::vector<float> sorted(sample.begin(), sample.end()), tones(picture.begin(), picture.end());
  std::sort(sorted.begin(), sorted.end());
  std::sort(tones.begin(), tones.end());
  for (float& value : sample) {
    // The middle of all that have this value.
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    value = tones[std::size_t((first - sorted.begin() + last - sorted.begin() - 1) / 2)];
  }
  return sample;
}

std::string pictures(const Surface& surface, const ForgedFit& fit) {
  const Grid<float> picture = shown_part(surface);
  const Surface block =
      surface_of(fit.material, {picture.rows() + rim_rows, picture.cols() + rim_cols}, sample_seed);
  const Grid<float> sample =
      with_the_tone_of(picture, crop(block.albedo.planes.front(), rim_rows / 2, rim_cols / 2,
                                     picture.rows(), picture.cols()));
  const auto figure = [&](const Grid<float>& grey, const std::string& caption) {
    Surface shown;
    shown.extent = {grey.rows(), grey.cols()};
    shown.mask = full_mask(shown.extent);
    shown.albedo = Image(grey);
    return map_figure({albedo_picture(shown), double(grey.cols()), "px", {}, caption});
  };
  return "<h2>The grain</h2>\n" +
         side_by_side({figure(picture, "The picture, its middle."),
                       figure(sample,
                              "Forged anew with the likeliest folds, one pixel a place, in "
                              "the tones of the picture; another block, not a copy.")});
}

int cell_at(const GrainAxis& axis, double frequency) {
  const int k = std::min(int(std::abs(frequency) * axis.length + 0.5), axis.length / 2);
  return int(std::upper_bound(axis.edges.begin(), axis.edges.end(), k) - axis.edges.begin()) - 1;
}

/// The frequency, in cycles per px, beyond which nothing but noise is expected.
double highest_frequency(const ForgedFit& fit) {
  const double least = *std::min_element(fit.model.begin(), fit.model.end());
  const GrainAxis &x = fit.spectrum.x, &y = fit.spectrum.y;
  double highest = 0.05;
  for (int r = 0; r < y.cells(); ++r) {
    for (int c = 0; c < x.cells(); ++c) {
      if (fit.model[std::size_t(r * x.cells() + c)] < 3.0 * least) continue;
      highest = std::max({highest, double(x.edges[std::size_t(c)]) / x.length,
                          double(y.edges[std::size_t(r)]) / y.length});
    }
  }
  return std::min(1.1 * highest, 0.5);
}

std::string spectra(const ForgedFit& fit) {
  const GrainAxis &x = fit.spectrum.x, &y = fit.spectrum.y;
  const auto [least, most] = std::minmax_element(fit.model.begin(), fit.model.end());
  const SpectrumStyle style{highest_frequency(fit),
                            {std::log10(0.3 * *least), std::log10(3.0 * *most)}};
  const auto figure = [&](const auto& power, const std::string& caption) {
    Grid<float> log_power(spectrum_px, spectrum_px);
    for (int row = 0; row < spectrum_px; ++row) {
      for (int col = 0; col < spectrum_px; ++col) {
        const double step = 2.0 * style.highest_frequency / spectrum_px;
        const int c = cell_at(x, (col + 0.5 - 0.5 * spectrum_px) * step);
        const int r = cell_at(y, (row + 0.5 - 0.5 * spectrum_px) * step);
        log_power(row, col) =
            float(std::log10(std::max(power[std::size_t(r * x.cells() + c)], 1e-300)));
      }
    }
    const Mask all(spectrum_px, spectrum_px, 1);
    return spectrum_figure(scalar_picture(log_power, all, style.log_power), style, "px", caption,
                           "px\u00b2");
  };
  return "<h2>Its spectrum</h2>\n" +
         paragraph("Tone undone, rows level; positive and negative frequencies together.") +
         side_by_side({figure(fit.spectrum.power, "Measured."),
                       figure(fit.model, "Fitted: the folds, noise, blur and levels.")});
}

std::string percent(double probability) {
  return fmt::format("{:.1f} %", 100.0 * probability);
}

std::string folds(const ForgedFit& fit) {
  std::vector<TableRow> rows;
  double rest = 1.0;
  for (const SequenceClass& one : fit.posterior) {
    if (rows.size() == most_sequences || one.probability < least_share) break;
    std::string words;
    for (const auto& sequence : one.sequences) words += (words.empty() ? "" : " or ") + sequence;
    rows.push_back(
        {{escaped(words), percent(one.probability), escaped(kind_of(one.sequences.front()))}});
    rest -= one.probability;
  }
  if (rest > least_share) rows.push_back({{"all others", percent(rest), ""}});
  return "<h2>Its folds</h2>\n" +
         paragraph("Sequences on one line cannot be told apart by a picture of this size.") +
         table({"sequence", "probability", "kind"}, rows) +
         table({"kind of grain", "probability"},
               {{{"masame (straight)", percent(fit.kinds.masame)}},
                {{"itame (plank)", percent(fit.kinds.itame)}},
                {{"mokume (burl)", percent(fit.kinds.mokume)}}});
}

std::string lead(const ForgedFit& fit) {
  return "<p class=\"lead\">" +
         escaped(fmt::format(
             "The steel was most probably folded {} ({} folds, probability {}): {}. The spectrum "
             "departs from the model by {:.2g} times the scatter of chance.",
             fit.material.sequence, fit.material.sequence.size(),
             percent(fit.posterior.front().probability), kind_of(fit.material.sequence),
             fit.deviance)) +
         "</p>\n";
}

}  // namespace

std::string forged_page(const std::string& name, const Surface& surface, const ForgedFit& fit) {
  return page("The folds of " + name, lead(fit) + pictures(surface, fit) + folds(fit) +
                                          spectra(fit) + "<h2>Remarks</h2>\n" +
                                          bullets(fit.remarks));
}

}  // namespace hada
