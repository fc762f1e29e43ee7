#include "bench/forged_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "core/parallel.h"
#include "core/quantile.h"
#include "core/srgb.h"
#include "fit/forged.h"
#include "synth/forged.h"

namespace hada {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Grid<float> blurred(const Grid<float>& image, double sigma_px) {
  const int reach = int(std::ceil(4.0 * sigma_px));
  std::vector<double> kernel;
  double sum = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(std::exp(-0.5 * k * k / (sigma_px * sigma_px)));
    sum += kernel.back();
  }
  const auto along = [&](const Grid<float>& from, int down, int right) {
    Grid<float> to(from.rows(), from.cols());
    for_each_index(from.rows(), [&](int row) {
      for (int col = 0; col < from.cols(); ++col) {
        double value = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int r = std::clamp(row + k * down, 0, from.rows() - 1);
          const int c = std::clamp(col + k * right, 0, from.cols() - 1);
          value += kernel[std::size_t(k + reach)] / sum * from(r, c);
        }
        to(row, col) = float(value);
      }
    });
    return to;
  };
  return along(along(image, 0, 1), 1, 0);
}

double deviation_of(const Grid<float>& values) {
  double sum = 0.0, squares = 0.0;
  for (const float v : values) {
    sum += v;
    squares += double(v) * v;
  }
  const auto n = double(values.size());
  return std::sqrt(squares / n - sum * sum / (n * n));
}

/// What a camera makes of grey values from 0 to 70.
void degrade(Grid<float>& grey, Seed seed) {
  const double noise = 0.1 * deviation_of(grey);
  grey = blurred(grey, 0.7);
  const double gamma = 0.6 + 1.2 * uniform(seed, 1);
  for (int row = 0; row < grey.rows(); ++row) {
    for (int col = 0; col < grey.cols(); ++col) {
      const double seen = grey(row, col) + noise * gaussian(seed, row, col, 2);
      const double tone = std::pow(std::clamp((seen + 20.0) / 110.0, 0.0, 1.0), gamma);
      grey(row, col) = float(std::round(255.0 * tone) / 255.0);
    }
  }
}

std::string random_sequence(int folds, Seed seed) {
  std::string sequence;
  for (int k = 0; k < folds; ++k) sequence += uniform(seed, k) < 0.5 ? 'C' : 'R';
  return sequence;
}

Surface picture(const std::string& sequence, const ForgedStudyOptions& o, Seed seed) {
  auto block = forged_block({.sequence = sequence}, {2048, 4096}, seed);
  quantise(block, 70.0, o.degraded ? 5.0 : 0.0);
  // Well inside, where the rim of the block is not felt.
  const int row = 400 + int(300 * uniform(seed, 1, 7)), col = 600 + int(900 * uniform(seed, 2, 7));
  Grid<float> grey = crop(block, row, col, o.rows, o.cols);
  if (o.degraded) {
    degrade(grey, seed + 1);
  } else {
    for (float& g : grey) g /= 70.0f;
  }
  for (float& g : grey) g = linear_from_srgb(g);
  Surface surface;
  surface.extent = {o.rows, o.cols};
  surface.mask = full_mask(surface.extent);
  surface.albedo = Image(std::move(grey));
  return surface;
}

std::string likeliest(const GrainKinds& k) {
  if (k.masame > std::max(k.itame, k.mokume)) return "masame";
  return k.itame > k.mokume ? "itame" : "mokume";
}

bool same_counts(const std::string& a, const std::string& b) {
  return a.size() == b.size() &&
         std::count(a.begin(), a.end(), 'C') == std::count(b.begin(), b.end(), 'C');
}

}  // namespace

std::vector<PaperGrain> paper_grains() {
  return {{"CCCCCCCC", 0},  {"CCCCCCCCCCCC", 0}, {"CRCRCRCRCRCR", 0}, {"CRCRCRCRCRCR", 1},
          {"CCRCCRCCR", 0}, {"CRCCRCCRC", 0},    {"RCCRCCRCC", 0},    {"CRCRCRCCC", 0}};
}

ForgedStudy study_forged(const ForgedStudyOptions& options) {
  ForgedStudy study;
  std::vector<double> seconds;
  const double share = 1.0 / options.pictures;
  int unsure_right = 0;
  for (int k = 0; k < options.pictures; ++k) {
    const Seed seed = 1000 + Seed(k) * 10;
    const std::string truth = random_sequence(options.folds, seed);
    const Surface surface = picture(truth, options, seed);
    const auto start = Clock::now();
    const auto fit =
        options.length_known
            ? fit_forged(surface, {.fewest_folds = options.folds, .most_folds = options.folds})
            : fit_forged(surface);
    seconds.push_back(seconds_since(start));
    const auto holds = [&](const SequenceClass& one) {
      return std::find(one.sequences.begin(), one.sequences.end(), truth) != one.sequences.end();
    };
    const auto place =
        std::find_if(fit.posterior.begin(), fit.posterior.end(), holds) - fit.posterior.begin();
    const bool listed = place < std::ptrdiff_t(fit.posterior.size());
    study.counts += same_counts(fit.material.sequence, truth) ? share : 0.0;
    study.first += listed && place == 0 ? share : 0.0;
    study.among_three += listed && place < 3 ? share : 0.0;
    study.kinds += likeliest(fit.kinds) == kind_of(truth) ? share : 0.0;
    for (const auto& one : fit.posterior) {
      if (one.probability < 0.4 || one.probability > 0.6) continue;
      ++study.unsure;
      unsure_right += holds(one);
    }
  }
  study.unsure_right = study.unsure > 0 ? double(unsure_right) / study.unsure : 0.0;
  study.seconds_median = median(seconds);
  return study;
}

GrainRings grain_rings(const std::string& sequence, int seeds) {
  constexpr int rows = 512, cols = 1024, rings = 32;
  constexpr double widest = 0.5;      // cycles per px
  constexpr double faintest = 1e-11;  // of the variance: floats round heights to 1e-15 of it
  std::vector<bool> visible(rings, false);
  std::vector<double> sums(rings, 0.0), squares(rings, 0.0);
  for (int seed = 0; seed < seeds; ++seed) {
    const auto block = forged_block({.sequence = sequence}, {1024, 16384}, Seed(seed));
    const auto spectrum = grain_spectrum(crop(block, 256, 7000, rows, cols), {.taper = 1.0});
    const auto model = grain_model(sequence, HammerKernel::both, spectrum);
    std::vector<double> measured(rings, 0.0), expected(rings, 0.0), counts(rings, 0.0);
    for (int r = 0; r < spectrum.y.cells(); ++r) {
      for (int c = 0; c < spectrum.x.cells(); ++c) {
        const double fx = double(spectrum.x.edges[std::size_t(c)]) / cols;
        const double fy = double(spectrum.y.edges[std::size_t(r)]) / rows;
        const int ring = int(std::hypot(fx, fy) / widest * rings);
        if (ring >= rings) continue;
        counts[std::size_t(ring)] += spectrum.count(r, c);
        measured[std::size_t(ring)] += spectrum.count(r, c) * spectrum.power(r, c);
        expected[std::size_t(ring)] += spectrum.count(r, c) * model.variance *
                                       model.along[std::size_t(c)] * model.down[std::size_t(r)];
      }
    }
    for (std::size_t k = 0; k < rings; ++k) {
      visible[k] = visible[k] || expected[k] > faintest * model.variance * counts[k];
      const double ratio = expected[k] > 0.0 ? measured[k] / expected[k] : 1.0;
      sums[k] += ratio;
      squares[k] += ratio * ratio;
    }
  }
  GrainRings result{sequence};
  for (std::size_t k = 0; k < rings; ++k) {
    if (!visible[k]) continue;
    const double mean = sums[k] / seeds;
    const double sigma = std::sqrt(std::max(squares[k] / seeds - mean * mean, 0.0) / (seeds - 1.0));
    ++result.rings;
    result.within_two_sigma += std::abs(mean - 1.0) <= 2.0 * sigma + 1e-3;
    result.within_three_sigma += std::abs(mean - 1.0) <= 3.0 * sigma + 1e-3;
    if (std::abs(mean - 1.0) > std::abs(result.worst_ratio - 1.0)) result.worst_ratio = mean;
  }
  return result;
}

double block_processor_seconds(const std::string& sequence, int repeats) {
  std::vector<double> seconds;
  for (int k = 0; k < repeats; ++k) {
    const std::clock_t start = std::clock();
    auto block = forged_block({.sequence = sequence}, {}, Seed(k));
    quantise(block, 70.0, 5.0);
    seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return median(seconds);
}

}  // namespace hada
