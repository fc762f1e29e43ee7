#include "synth/white_noise.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hada {
namespace {

constexpr int layers = 256;
constexpr double tail_begin = 3.6541528853610088;  // of 256 layers, as in the source
constexpr double layer_area = 0.00492867323399;

double bell(double x) {
  return std::exp(-0.5 * x * x);
}

/// The right ends of the layers under the bell curve, widest first, and the heights there.
struct Ziggurat {
  std::array<double, layers + 1> end;
  std::array<double, layers + 1> height;

  Ziggurat() {
    end[0] = layer_area / bell(tail_begin);  // the lowest layer with its tail, as wide as its area
    end[1] = tail_begin;
    for (int k = 2; k < layers; ++k) {
      const double below = end[std::size_t(k - 1)];
      end[std::size_t(k)] = std::sqrt(-2.0 * std::log(layer_area / below + bell(below)));
    }
    end[layers] = 0.0;
    for (std::size_t k = 0; k <= layers; ++k) height[k] = bell(end[k]);
  }
};

const Ziggurat ziggurat;

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double unit_of(std::uint64_t bits) {
  return (double(bits >> 11) + 0.5) * 0x1p-53;
}

}  // namespace

double normal_of(std::uint64_t bits) {
  // Whoever is turned away draws further bits from the stream that these begin.
  for (std::uint64_t k = 1;; ++k) {
    const auto layer = std::size_t(bits & 255u);
    const double sign = bits & 256u ? -1.0 : 1.0;
    const double x = unit_of(bits) * ziggurat.end[layer];
    if (x < ziggurat.end[layer + 1]) return sign * x;
    const double u = unit_of(mixed(bits + 2 * k));
    if (layer == 0) {
      // Marsaglia, Generating a variable from the tail of the normal distribution (1964).
      for (std::uint64_t t = 1;; ++t) {
        const double beyond = -std::log(unit_of(mixed(bits + 4 * t + 1))) / tail_begin;
        const double y = -std::log(unit_of(mixed(bits + 4 * t + 3)));
        if (y + y >= beyond * beyond) return sign * (tail_begin + beyond);
      }
    }
    const double low = ziggurat.height[layer], high = ziggurat.height[layer + 1];
    if (low + u * (high - low) < bell(x)) return sign * x;
    bits = mixed(bits ^ k);
  }
}

void fill_white_noise(std::span<float> row, Seed seed, int row_number) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  std::uint64_t state = hash(seed, row_number);
  for (float& value : row) value = float(normal_of(mixed(state += golden)));
}

}  // namespace hada
