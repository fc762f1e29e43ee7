#include "synth/endless.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "synth/echoes.h"
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

/// A pass for every place that the noise comes back at: for kernels too fine for an `EchoLattice`.
void add_passes(Grid<float>& field, WrinkleComponent<> kernel, const Echoes& one,
                const Echoes& other, std::uint64_t key, const Extent& window,
                const std::array<double, 2>& middle) {
  const double amplitude = kernel.amplitude_mm;
  const int last = int(one.loudness.size()) - 1, other_last = int(other.loudness.size()) - 1;
  constexpr double most = 1e10;  // pixels in all passes: some minutes
  const double places = (2.0 * last + 1.0) * (2.0 * other_last + 1.0);
  if (places * double(field.size()) > most) {
    throw Error(
        "synthesis: a window of so many pixels, and noise that comes back at " +
        std::to_string(std::int64_t(places)) +
        " places and is finer than a pixel, or comes back twice one way, take too long; ask for a "
        "smaller window, or for a surface that tiles");
  }
  for (int m = -other_last; m <= other_last; ++m) {
    for (int n = -last; n <= last; ++n) {
      kernel.amplitude_mm = amplitude * one.loudness[std::size_t(std::abs(n))] *
                            other.loudness[std::size_t(std::abs(m))];
      const double x = n * one.step.x + m * other.step.x;
      const double y = n * one.step.y + m * other.step.y;
      Layer(kernel, key).add_to(field, window, {middle[0] - x, middle[1] - y});
    }
  }
}

void add_coming_back(Grid<float>& field, const WrinkleComponent<>& kernel, const Echoes& one,
                     const Echoes& other, std::uint64_t key, const Extent& window,
                     const std::array<double, 2>& middle) {
  if (const auto lattice = EchoLattice::find(kernel, one, other, window.pitch)) {
    lattice->add_to(field, window, middle, key);
  } else {
    add_passes(field, kernel, one, other, key, window, middle);
  }
}

void add_repeated(Grid<float>& field, const RepeatedNoise<>& noise, std::uint64_t key,
                  const Extent& window, const std::array<double, 2>& middle) {
  const auto covariance = autocovariance(noise);
  WrinkleComponent<> kernel = kernel_of(noise);
  kernel.amplitude_mm = std::sqrt(covariance.kernel.variance);
  const Step<> step{covariance.x, covariance.y};
  add_coming_back(field, kernel, echoes_of(step, noise.repeats), none_across(step, kernel), key,
                  window, middle);
}

void add_woven(Grid<float>& field, const WovenNoise<>& noise, std::uint64_t key,
               const Extent& window, const std::array<double, 2>& middle) {
  const auto covariance = autocovariance(noise);
  const WrinkleComponent<> kernel{std::sqrt(covariance.kernel.variance), noise.long_mm,
                                  noise.short_mm, noise.angle_rad};
  add_coming_back(field, kernel, echoes_of(covariance.p, noise.repeats),
                  echoes_of(covariance.q, noise.other_repeats), key, window, middle);
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
  const int margin = has_ridges(wrinkle) ? felt_by_ridges(wrinkle, window.pitch) : 0;
  const Extent wider{window.rows + 2 * margin, window.cols + 2 * margin, window.pitch, window.unit};
  Grid<float> field(wider.rows, wider.cols);
  // What comes back first: it may be refused.
  std::int64_t layer = std::int64_t(wrinkle.components.size());
  for (const auto& noise : wrinkle.repeated)
    add_repeated(field, noise, mixed(seed, ++layer), wider, middle);
  for (const auto& noise : wrinkle.woven)
    add_woven(field, noise, mixed(seed, ++layer), wider, middle);
  layer = 0;
  for (const auto& component : wrinkle.components)
    Layer(component, mixed(seed, ++layer)).add_to(field, wider, middle);
  if (has_ridges(wrinkle)) {
    field = crop(with_layers(std::move(field), wrinkle, window.pitch, false), margin, margin,
                 window.rows, window.cols);
  }
  if (wrinkle.floor_mm4 > 0.0) add_floor(field, window, middle, wrinkle.floor_mm4, mixed(seed, 0));
  return field;
}

}  // namespace hada
