#include "bench/figure_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "fit/figure.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

}  // namespace

FigureScore study_figures(int seeds) {
  constexpr int side = 64, lights = 9;
  FigureScore score;
  for (int k = 0; k < seeds; ++k) {
    const Seed seed = Seed(5000 + k);
    const double specular = 0.1 + 0.1 * uniform(seed, 0),
                 sharpness = 12.0 + 20.0 * uniform(seed, 1);
    const double wave = 0.12 + 0.15 * uniform(seed, 2), phase = 6.0 * uniform(seed, 3);
    const auto dive = [&](int row, int col) {
      return 0.1 * std::sin(wave * row + 0.05 * col + phase) + 0.04 * std::cos(0.13 * col);
    };
    LightStack stack;
    stack.camera.extent = {side, side, 0.2, Unit::mm};
    stack.mask = Mask(side, side, 1);
    for (int i = 0; i < lights; ++i) {
      const double along = (-32.0 + 8.0 * i) * degree, across = (i % 3 - 1) * 8.0 * degree;
      Light light;
      light.direction = Eigen::Vector3d(std::sin(across) * std::cos(along), std::sin(along),
                                        std::cos(across) * std::cos(along));
      Grid<float> seen(side, side);
      for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
          const double matte = 0.25 + 0.1 * uniform(seed, 4, row / 4, col / 4);
          const double lobe = std::pow(std::cos(along - dive(row, col)), sharpness);
          const double value = (matte * light.direction.z() + specular * lobe) *
                               (1.0 + 0.01 * gaussian(seed, i, row, col));
          seen(row, col) = float(std::round(value * 65535.0) / 65535.0);
        }
      }
      stack.images.push_back(Image(seen));
      stack.lights.push_back(light);
      stack.samples.push_back(Grid<Sample>(side, side, Sample::lit));
    }
    const Figure figure = figure_of(stack);
    double off = 0.0;
    for (int row = 0; row < side; ++row) {
      for (int col = 0; col < side; ++col)
        off += std::abs(figure.dive_rad(row, col) - dive(row, col)) / (side * side);
    }
    score.specular = std::max(score.specular, std::abs(figure.specular / specular - 1.0));
    score.sharpness = std::max(score.sharpness, std::abs(figure.sharpness / sharpness - 1.0));
    score.dive_deg = std::max(score.dive_deg, off / degree);
  }
  return score;
}

}  // namespace hada
