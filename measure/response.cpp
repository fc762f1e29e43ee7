#include "measure/response.h"

#include <cmath>
#include <numbers>

namespace hada {
namespace {

double sinc(double x) {
  return std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x;
}

}  // namespace

double mean_amplitude(double fx, double fy, double pitch) {
  return sinc(std::numbers::pi * fx * pitch) * sinc(std::numbers::pi * fy * pitch);
}

double photographed_amplitude(double fx, double fy, double pitch) {
  const double x = std::numbers::pi * fx * pitch;
  const double y = std::numbers::pi * fy * pitch;
  const double differences = std::pow(std::sin(x), 2) + std::pow(std::sin(y), 2);
  if (differences < 1e-12) return 1.0;
  const double integrated = (x * std::sin(2.0 * x) + y * std::sin(2.0 * y)) / (2.0 * differences);
  return mean_amplitude(fx, fy, pitch) * integrated;
}

double lens_amplitude(double fx, double fy, double sigma) {
  return std::exp(-2.0 * std::pow(std::numbers::pi * sigma, 2) * (fx * fx + fy * fy));
}

double integrated_noise(double fx, double fy, double pitch) {
  const double x = std::numbers::pi * fx * pitch;
  const double y = std::numbers::pi * fy * pitch;
  const double differences = std::pow(std::sin(x), 2) + std::pow(std::sin(y), 2);
  const double slopes = std::pow(std::sin(2.0 * x), 2) + std::pow(std::sin(2.0 * y), 2);
  return std::pow(pitch, 4) * slopes / (16.0 * std::max(differences * differences, 1e-24));
}

}  // namespace hada
