#include "fit/ring_colours.h"

#include <algorithm>
#include <cmath>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr int bins = 64;  // of the phase within a ring
constexpr int parts = 6;  // of the picture, to leave out one after the other
constexpr double wanted_pixels = 120000.0;

using Colour = std::array<double, 3>;
/// Median colour of each phase.
using Profile = std::array<Colour, bins>;

double eased(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double phase_of(int bin) {
  return (bin + 0.5) / bins;
}

/// How late the wood at this phase is, 0 to 1, in the mean of a pixel `blur` of a ring wide.
double blurred_late(double phase, double share, double onset, double blur) {
  constexpr int places = 5;
  double sum = 0.0;
  for (int k = 0; k < places; ++k) {
    double at = phase + blur * ((k + 0.5) / places - 0.5);
    at -= std::floor(at);  // the ring before or after
    sum += eased((at - 1.0 + share) / std::max(onset * share, 0.5 / bins));
  }
  return sum / places;
}

/// Early and late colour by least squares for this share and onset, and what is left of green.
struct Trial {
  Colour early, late;
  double misfit;
};

Trial tried(const Profile& profile, double share, double onset, double blur) {
  double n = 0.0, l = 0.0, ll = 0.0;
  Colour y{}, ly{}, yy{};
  for (int bin = 0; bin < bins; ++bin) {
    const double late = blurred_late(phase_of(bin), share, onset, blur);
    n += 1.0;
    l += late;
    ll += late * late;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = profile[std::size_t(bin)][c];
      y[c] += value;
      ly[c] += late * value;
      yy[c] += value * value;
    }
  }
  Trial trial{{}, {}, 0.0};
  const double det = n * ll - l * l;
  for (std::size_t c = 0; c < 3; ++c) {
    const double step = det > 1e-9 ? (n * ly[c] - l * y[c]) / det : 0.0;
    trial.early[c] = (y[c] - step * l) / n;
    trial.late[c] = trial.early[c] + step;
    trial.misfit += yy[c] - trial.early[c] * y[c] - step * ly[c];
  }
  return trial;
}

/// The best share and onset, over a lattice and then ever closer around its best point.
RingColours fitted(const Profile& profile, double blur) {
  double share = 0.5, onset = 0.5, reach = 0.5;
  double least = HUGE_VAL;
  for (int round = 0; round < 5; ++round, reach *= 0.25) {
    const double from_share = share, from_onset = onset;
    for (int i = -12; i <= 12; ++i) {
      for (int j = -12; j <= 12; ++j) {
        const double s = std::clamp(from_share + reach * i / 12.0, 0.02, 0.98);
        const double o = std::clamp(from_onset + reach * j / 12.0, 0.02, 1.0);
        const double misfit = tried(profile, s, o, blur).misfit;
        if (misfit >= least) continue;
        least = misfit;
        share = s;
        onset = o;
      }
    }
  }
  const Trial best = tried(profile, share, onset, blur);
  RingColours found{best.early, best.late, share, onset};
  for (std::size_t c = 0; c < 3; ++c) {
    found.early[c] = std::clamp(found.early[c], 0.0, 1.0);
    found.late[c] = std::clamp(found.late[c], 0.0, 1.0);
  }
  return found;
}

struct Sample {
  int part;
  int bin;
  Colour colour;
};

Profile profile_of(const std::vector<Sample>& samples, int without) {
  std::array<std::array<std::vector<double>, 3>, bins> values;
  for (const Sample& sample : samples) {
    if (sample.part == without) continue;
    for (std::size_t c = 0; c < 3; ++c)
      values[std::size_t(sample.bin)][c].push_back(sample.colour[c]);
  }
  Profile profile{};
  Colour before{};
  for (std::size_t bin = 0; bin < bins; ++bin) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!values[bin][c].empty()) before[c] = median(values[bin][c]);
      profile[bin][c] = before[c];
    }
  }
  return profile;
}

std::vector<Sample> samples_of(const Surface& surface, const Mask& mask, const GrowthFrame& frame,
                               const std::vector<double>& radii) {
  const Extent& extent = surface.extent;
  const int step = std::max(1, int(std::sqrt(double(extent.rows) * extent.cols / wanted_pixels)));
  const auto& planes = surface.albedo.planes;
  std::vector<Sample> samples;
  for (int row = 0; row < extent.rows; row += step) {
    for (int col = 0; col < extent.cols; col += step) {
      if (!mask(row, col)) continue;
      const double rho = frame.rho_of(extent.place(row, col));
      const auto after = std::upper_bound(radii.begin(), radii.end(), rho);
      if (after == radii.begin() || after == radii.end()) continue;
      const double phase = (rho - *(after - 1)) / (*after - *(after - 1));
      Sample sample{col * parts / extent.cols, std::min(bins - 1, int(phase * bins)), {}};
      for (std::size_t c = 0; c < 3; ++c)
        sample.colour[c] = double(planes[std::min(c, planes.size() - 1)](row, col));
      samples.push_back(sample);
    }
  }
  return samples;
}

}  // namespace

RingColourFit ring_colours(const Surface& surface, const Mask& mask, const GrowthFrame& frame,
                           const std::vector<double>& radii) {
  const auto samples = samples_of(surface, mask, frame, radii);
  std::vector<double> widths;
  for (std::size_t k = 1; k < radii.size(); ++k) widths.push_back(radii[k] - radii[k - 1]);
  const double blur = surface.extent.pitch / std::max(median(widths), surface.extent.pitch);
  RingColourFit fit{fitted(profile_of(samples, -1), blur), {}};
  std::array<RingColours, parts> without;
  for (int part = 0; part < parts; ++part)
    without[std::size_t(part)] = fitted(profile_of(samples, part), blur);
  const auto spread = [&](const auto& value, double blurred) {
    // Jackknife (Tukey 1958), and what the pitch does not let one see.
    double sum = 0.0;
    for (const RingColours& one : without)
      sum += (value(one) - value(fit.found)) * (value(one) - value(fit.found));
    return std::hypot(std::sqrt(sum * (parts - 1.0) / parts), blurred);
  };
  const double share = std::max(fit.found.latewood_share, 0.02);
  fit.sigma.latewood_share =
      spread([](const RingColours& c) { return c.latewood_share; }, 0.5 * blur);
  fit.sigma.latewood_onset =
      spread([](const RingColours& c) { return c.latewood_onset; }, std::min(blur / share, 0.3));
  for (std::size_t c = 0; c < 3; ++c) {
    const double contrast = std::abs(fit.found.early[c] - fit.found.late[c]);
    const double blurred = 0.5 * contrast * std::min(blur / share, 1.0);
    fit.sigma.early[c] =
        spread([c](const RingColours& one) { return one.early[c]; }, 0.02 * blurred);
    fit.sigma.late[c] = spread([c](const RingColours& one) { return one.late[c]; }, blurred);
  }
  return fit;
}

}  // namespace hada
