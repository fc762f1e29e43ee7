#include "bench/forged_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

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

/// The picture of a block that lies askew: each pixel the mean of four places between others.
Grid<float> photographed(const Grid<float>& block, int row, int col, const ForgedStudyOptions& o,
                         Seed seed) {
  const double angle = (2.0 * uniform(seed, 1, 3) - 1.0) * 4.0 * std::numbers::pi / 180.0;
  const double scale = std::exp(0.15 * (2.0 * uniform(seed, 2, 3) - 1.0));
  const double aspect = std::exp(0.05 * (2.0 * uniform(seed, 3, 3) - 1.0));
  const double c = std::cos(angle), s = std::sin(angle);
  Grid<float> picture(o.rows, o.cols);
  for_each_index(o.rows, [&](int r) {
    for (int k = 0; k < o.cols; ++k) {
      double sum = 0.0;
      for (const double down : {-0.25, 0.25}) {
        for (const double right : {-0.25, 0.25}) {
          const double x = k + right - 0.5 * o.cols, y = 0.5 * o.rows - r - down;
          const double at_col = col + 0.5 * o.cols + (c * x + s * y) / (scale * aspect);
          const double at_row = row + 0.5 * o.rows - (c * y - s * x) / scale;
          const int i = int(at_row), j = int(at_col);
          const double a = at_row - i, b = at_col - j;
          sum += (1 - a) * ((1 - b) * block(i, j) + b * block(i, j + 1)) +
                 a * ((1 - b) * block(i + 1, j) + b * block(i + 1, j + 1));
        }
      }
      picture(r, k) = float(0.25 * sum);
    }
  });
  return picture;
}

std::string random_sequence(int folds, Seed seed) {
  std::string sequence;
  for (int k = 0; k < folds; ++k) sequence += uniform(seed, k) < 0.5 ? 'C' : 'R';
  return sequence;
}

Surface picture(const std::string& sequence, const ForgedStudyOptions& o, Seed seed) {
  auto block = forged_block({.sequence = sequence}, {2048, 4096}, seed);
  quantise(block, 70.0, o.picture == GrainPicture::clean ? 0.0 : 5.0);
  // Well inside, where the rim of the block is not felt.
  const int row = 400 + int(300 * uniform(seed, 1, 7)), col = 600 + int(900 * uniform(seed, 2, 7));
  Grid<float> grey =
      o.turned ? photographed(block, row, col, o, seed + 2) : crop(block, row, col, o.rows, o.cols);
  if (o.picture == GrainPicture::photograph) {
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

/// Places from the rim of a block inwards where it is felt, that nothing lies beyond it.
int rim(const std::string& sequence, char cut) {
  int places = 0;
  for (const char fold : sequence) places = (fold == cut ? 2 * places : places) + 1;
  return places;
}

/// Places after which the statistics of a block repeat.
int period(const std::string& sequence, char cut) {
  return 1 << std::count(sequence.begin(), sequence.end(), cut);
}

/// The bits of `k` behind the point, the lowest first: van der Corput's even sequence in [0, 1).
double radical_inverse(int k) {
  double value = 0.0;
  for (double bit = 0.5; k > 0; k /= 2, bit /= 2.0) value += (k % 2) * bit;
  return value;
}

constexpr std::size_t ring_count = 32;

struct RingSums {
  std::vector<double> ordinates = std::vector<double>(ring_count, 0.0);
  std::vector<double> measured = ordinates;
  std::vector<double> expected = ordinates;  // of grain of variance 1
};

RingSums ring_sums(const GrainSpectrum& spectrum, const GrainModel& model) {
  constexpr double widest = 0.5;  // cycles per px
  RingSums sums;
  for (int r = 0; r < spectrum.y.cells(); ++r) {
    for (int c = 0; c < spectrum.x.cells(); ++c) {
      const double fx = double(spectrum.x.edges[std::size_t(c)]) / spectrum.x.length;
      const double fy = double(spectrum.y.edges[std::size_t(r)]) / spectrum.y.length;
      const auto ring = std::size_t(std::hypot(fx, fy) / widest * ring_count);
      if (ring >= ring_count) continue;
      const double count = spectrum.count(r, c);
      sums.ordinates[ring] += count;
      sums.measured[ring] += count * spectrum.power(r, c);
      sums.expected[ring] += count * model.along[std::size_t(c)] * model.down[std::size_t(r)];
    }
  }
  return sums;
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
    ForgedFitOptions how;
    if (options.length_known) how.fewest_folds = how.most_folds = options.folds;
    if (!options.turned) how.view = GrainView::block;
    const auto fit = fit_forged(surface, how);
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
  constexpr int rows = 512, cols = 1024;
  constexpr double faintest = 1e-11;  // of the variance: floats round heights to 1e-15 of it
  const int rim_x = rim(sequence, 'C'), rim_y = rim(sequence, 'R');
  const int period_x = period(sequence, 'C'), period_y = period(sequence, 'R');
  const BlockSize size =
      divisible({rows + 2 * rim_y + period_y, cols + 2 * rim_x + period_x}, sequence);
  std::vector<std::vector<double>> ratios(ring_count);
  for (int seed = 0; seed < seeds; ++seed) {
    const auto block = forged_block({.sequence = sequence}, size, Seed(seed));
    const int row = rim_y + int(period_y * radical_inverse(seed));
    const int col = rim_x + int(period_x * (seed + 0.5) / seeds);
    const auto spectrum = grain_spectrum(crop(block, row, col, rows, cols), {.taper = 1.0});
    const auto model = grain_model(sequence, HammerKernel::both, spectrum);
    const RingSums sums = ring_sums(spectrum, model);
    for (std::size_t k = 0; k < ring_count; ++k) {
      if (sums.expected[k] > faintest * sums.ordinates[k])
        ratios[k].push_back(sums.measured[k] / (model.variance * sums.expected[k]));
    }
  }
  GrainRings result{sequence};
  std::vector<double> sigmas;
  for (const auto& ratio : ratios) {
    if (ratio.empty()) continue;
    const auto n = double(ratio.size());
    double sum = 0.0, differences = 0.0;
    for (std::size_t k = 0; k < ratio.size(); ++k) {
      sum += ratio[k];
      if (k > 0) differences += (ratio[k] - ratio[k - 1]) * (ratio[k] - ratio[k - 1]);
    }
    const double off = sum / n - 1.0;
    sigmas.push_back(std::sqrt(differences / (2.0 * (n - 1.0) * n)));
    ++result.rings;
    result.within_two_sigma += std::abs(off) <= 2.0 * sigmas.back();
    result.within_sampling += std::abs(off) <= ring_sampling_sigmas * sigmas.back();
    if (std::abs(off) > std::abs(result.worst_ratio - 1.0)) result.worst_ratio = 1.0 + off;
  }
  result.sigma_median = median(sigmas);
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
