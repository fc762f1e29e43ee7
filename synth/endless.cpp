#include "synth/endless.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "synth/ridges.h"
#include "synth/white_noise.h"

namespace hada {
namespace {

constexpr double spacing = 1.5;  // of the nodes, in standard deviations of the kernel
constexpr int reach = 4;         // nodes on each side: the kernel has fallen to 1e-8
constexpr int taps = 2 * reach;
constexpr double fall = 0.5 * spacing * spacing;  // the kernel at distance t is exp(-fall t^2)

/// The nodes that are felt at a place on one axis: the first of them, and how strongly each.
struct Felt {
  std::int64_t first;
  std::array<float, taps> weight;
};

/// exp(-fall (t - k)^2) = exp(-fall t^2) exp(2 fall t)^k exp(-fall k^2): two exponentials for all.
Felt felt_at(double node) {
  static const std::array<double, taps> at_node = [] {
    std::array<double, taps> values;
    for (int i = 0; i < taps; ++i) values[std::size_t(i)] = std::exp(-fall * std::pow(i - 3, 2));
    return values;
  }();
  const double whole = std::floor(node), t = node - whole;
  const double ratio = std::exp(2.0 * fall * t);
  double rising = std::exp(-fall * t * t) / (ratio * ratio * ratio);
  Felt felt{std::int64_t(whole) - 3, {}};
  for (int i = 0; i < taps; ++i) {
    felt.weight[std::size_t(i)] = float(rising * at_node[std::size_t(i)]);
    rising *= ratio;
  }
  return felt;
}

/// The normal numbers of a rectangle of nodes.
class Nodes {
 public:
  using Range = std::array<std::int64_t, 2>;  // first and one past the last

  Nodes(std::uint64_t key, const Range& along, const Range& across)
      : along_(along),
        across_(across),
        values_(int(along[1] - along[0]), int(across[1] - across[0])) {
    for_each_index(values_.rows(), [&](int row) {
      const std::uint64_t of_row = mixed(key, along[0] + row);
      for (int col = 0; col < values_.cols(); ++col)
        values_(row, col) = float(normal_of(mixed(of_row, across[0] + col)));
    });
  }

  float sum(const Felt& along, const Felt& across) const {
    const int row = int(along.first - along_[0]), col = int(across.first - across_[0]);
    float total = 0.0f;
    for (int i = 0; i < taps; ++i) {
      const float* const line = &values_(row + i, col);
      float part = 0.0f;
      for (int k = 0; k < taps; ++k) part += across.weight[std::size_t(k)] * line[k];
      total += along.weight[std::size_t(i)] * part;
    }
    return total;
  }

 private:
  Range along_, across_;
  Grid<float> values_;
};

/// The same numbers, made where they are asked for: for kernels much finer than a pixel.
struct NodesAsAsked {
  std::uint64_t key;

  float sum(const Felt& along, const Felt& across) const {
    float total = 0.0f;
    for (int i = 0; i < taps; ++i) {
      const std::uint64_t of_row = mixed(key, along.first + i);
      float part = 0.0f;
      for (int k = 0; k < taps; ++k)
        part += across.weight[std::size_t(k)] * float(normal_of(mixed(of_row, across.first + k)));
      total += along.weight[std::size_t(i)] * part;
    }
    return total;
  }
};

/// One noise function on its lattice of nodes.
class Layer {
 public:
  Layer(const WrinkleComponent<>& component, std::uint64_t key)
      : cosine_(std::cos(component.angle_rad)),
        sine_(std::sin(component.angle_rad)),
        per_along_(1.0 / (spacing * component.long_mm)),
        per_across_(1.0 / (spacing * component.short_mm)),
        // The squares of the weights of one axis add up to sqrt(pi) / spacing.
        scale_(float(component.amplitude_mm * spacing / std::sqrt(std::numbers::pi))),
        key_(key) {}

  void add_to(Grid<float>& field, const Extent& window, const std::array<double, 2>& middle) const {
    const double half_width = 0.5 * window.width(), half_height = 0.5 * window.height();
    const auto range = [&](double per_x, double per_y) {
      const double at = per_x * middle[0] + per_y * middle[1];
      const double half = std::abs(per_x) * half_width + std::abs(per_y) * half_height;
      return Nodes::Range{std::int64_t(std::floor(at - half)) - reach,
                          std::int64_t(std::ceil(at + half)) + reach + 1};
    };
    const auto along = range(per_along_ * cosine_, per_along_ * sine_);
    const auto across = range(-per_across_ * sine_, per_across_ * cosine_);
    const double nodes = double(along[1] - along[0]) * double(across[1] - across[0]);
    const double most = 1e4 + 16.0 * double(field.size());  // more than so many are not kept
    if (nodes < most) {
      add(Nodes(key_, along, across), field, window, middle);
    } else {
      add(NodesAsAsked{key_}, field, window, middle);
    }
  }

 private:
  template <class Numbers>
  void add(const Numbers& numbers, Grid<float>& field, const Extent& window,
           const std::array<double, 2>& middle) const {
    for_each_index(field.rows(), [&](int row) {
      for (int col = 0; col < field.cols(); ++col) {
        const auto place = window.place(row, col);
        const double x = middle[0] + place.x(), y = middle[1] + place.y();
        const Felt along = felt_at((cosine_ * x + sine_ * y) * per_along_);
        const Felt across = felt_at((cosine_ * y - sine_ * x) * per_across_);
        field(row, col) += scale_ * numbers.sum(along, across);
      }
    });
  }

  double cosine_, sine_, per_along_, per_across_;
  float scale_;
  std::uint64_t key_;
};

/// How loud white noise must be heard again n periods away, n = 0, 1, ..., until that is a hundred
/// thousandth: at a distance of n periods the sum then resembles itself by exp(-n^2 / (2
/// repeats^2)). The coefficients of the series of the root of the spectrum's comb.
std::vector<double> echoes(double repeats) {
  constexpr double faintest = 1e-5;
  const double width = 0.5 / (std::numbers::pi * repeats);
  // exp(-n^2 / repeats^2) for many repeats; the root is less smooth where its lines flow together.
  const int last = int(std::ceil(4.0 * repeats)) + 6;
  const int phases = 16 * last;  // of a periodic function: the mean of them is the integral
  std::vector<double> roots;
  for (int k = 0; k < phases; ++k) roots.push_back(std::sqrt(comb(double(k) / phases, width)));
  std::vector<double> loudness;
  for (int n = 0; n <= last; ++n) {
    double sum = 0.0;
    for (int k = 0; k < phases; ++k)
      sum += roots[std::size_t(k)] * std::cos(2.0 * std::numbers::pi * n * k / phases);
    if (n > 0 && std::abs(sum / phases) < faintest * loudness.front()) break;
    loudness.push_back(sum / phases);
  }
  return loudness;
}

void check_effort(const Wrinkle<>& wrinkle, const Extent& window) {
  constexpr double most = 1e10;  // pixels in all passes: some minutes
  const auto check = [&](double places) {
    if (places * window.rows * window.cols > most) {
      throw Error("synthesis: a window of so many pixels, and noise that comes back at " +
                  std::to_string(std::int64_t(places)) +
                  " places, take too long; ask for a smaller window, or for a surface that tiles");
    }
  };
  const auto places = [](double repeats) { return 2.0 * double(echoes(repeats).size()) - 1.0; };
  for (const auto& noise : wrinkle.repeated) check(places(noise.repeats));
  for (const auto& noise : wrinkle.woven)
    check(places(noise.repeats) * places(noise.other_repeats));
}

void add_repeated(Grid<float>& field, const RepeatedNoise<>& noise, std::uint64_t key,
                  const Extent& window, const std::array<double, 2>& middle) {
  const auto covariance = autocovariance(noise);
  const auto loudness = echoes(noise.repeats);
  const int last = int(loudness.size()) - 1;
  WrinkleComponent<> kernel = kernel_of(noise);
  for (int n = -last; n <= last; ++n) {
    kernel.amplitude_mm =
        std::sqrt(covariance.kernel.variance) * loudness[std::size_t(std::abs(n))];
    Layer(kernel, key)
        .add_to(field, window, {middle[0] - n * covariance.x, middle[1] - n * covariance.y});
  }
}

void add_woven(Grid<float>& field, const WovenNoise<>& noise, std::uint64_t key,
               const Extent& window, const std::array<double, 2>& middle) {
  const auto covariance = autocovariance(noise);
  const auto loudness = echoes(noise.repeats), other = echoes(noise.other_repeats);
  const int last = int(loudness.size()) - 1, other_last = int(other.size()) - 1;
  WrinkleComponent<> kernel{noise.amplitude_mm, noise.long_mm, noise.short_mm, noise.angle_rad};
  const double amplitude = std::sqrt(covariance.kernel.variance);
  for (int m = -other_last; m <= other_last; ++m) {
    for (int n = -last; n <= last; ++n) {
      kernel.amplitude_mm =
          amplitude * loudness[std::size_t(std::abs(n))] * other[std::size_t(std::abs(m))];
      const Step<> away{n * covariance.p.x + m * covariance.q.x,
                        n * covariance.p.y + m * covariance.q.y};
      Layer(kernel, key).add_to(field, window, {middle[0] - away.x, middle[1] - away.y});
    }
  }
}

void add_floor(Grid<float>& field, const Extent& window, const std::array<double, 2>& middle,
               double density, std::uint64_t key) {
  const double deviation = std::sqrt(density) / window.pitch;
  for_each_index(field.rows(), [&](int row) {
    for (int col = 0; col < field.cols(); ++col) {
      const auto place = window.place(row, col);
      // A quarter of a pixel on: centres lie on halves or wholes of the pitch, and round the same.
      const auto cell = [&](double at) {
        return std::int64_t(std::floor(at / window.pitch + 0.25));
      };
      const std::uint64_t of_row = mixed(key, cell(middle[1] + place.y()));
      field(row, col) += float(deviation * normal_of(mixed(of_row, cell(middle[0] + place.x()))));
    }
  });
}

}  // namespace

Grid<float> endless_field(const Wrinkle<>& wrinkle, const Extent& window,
                          const std::array<double, 2>& middle, Seed seed) {
  check_effort(wrinkle, window);
  const int margin = has_ridges(wrinkle) ? felt_by_ridges(wrinkle, window.pitch) : 0;
  const Extent wider{window.rows + 2 * margin, window.cols + 2 * margin, window.pitch, window.unit};
  Grid<float> field(wider.rows, wider.cols);
  std::int64_t layer = 0;
  for (const auto& component : wrinkle.components)
    Layer(component, mixed(seed, ++layer)).add_to(field, wider, middle);
  for (const auto& noise : wrinkle.repeated)
    add_repeated(field, noise, mixed(seed, ++layer), wider, middle);
  for (const auto& noise : wrinkle.woven)
    add_woven(field, noise, mixed(seed, ++layer), wider, middle);
  if (has_ridges(wrinkle)) {
    field = crop(with_layers(std::move(field), wrinkle, window.pitch, false), margin, margin,
                 window.rows, window.cols);
  }
  if (wrinkle.floor_mm4 > 0.0) add_floor(field, window, middle, wrinkle.floor_mm4, mixed(seed, 0));
  return field;
}

}  // namespace hada
