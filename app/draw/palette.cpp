#include "app/draw/palette.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/image_file.h"

namespace hada {
namespace {

struct OkLab {
  double lightness;
  double green_red;
  double blue_yellow;
};

// Source: B. Ottosson, A perceptual color space for image processing (2020).
Colour srgb_of(const OkLab& lab) {
  const double l =
      std::pow(lab.lightness + 0.3963377774 * lab.green_red + 0.2158037573 * lab.blue_yellow, 3.0);
  const double m =
      std::pow(lab.lightness - 0.1055613458 * lab.green_red - 0.0638541728 * lab.blue_yellow, 3.0);
  const double s =
      std::pow(lab.lightness - 0.0894841775 * lab.green_red - 1.2914855480 * lab.blue_yellow, 3.0);
  const double linear[3] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) {
    colour[c] = srgb_from_linear(float(std::clamp(linear[c], 0.0, 1.0)));
  }
  return colour;
}

// A parabola through three values, at shares 0, 1/2 and 1.
double through(double start, double middle, double end, double share) {
  return start * (1.0 - share) * (1.0 - 2.0 * share) + 4.0 * middle * share * (1.0 - share) +
         end * share * (2.0 * share - 1.0);
}

}  // namespace

Colour sequential(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return srgb_of(
      {0.27 + 0.66 * s, through(0.02, -0.09, -0.03, s), through(-0.125, -0.01, 0.155, s)});
}

Colour diverging(double share) {
  const double s = std::clamp(share, -1.0, 1.0);
  const double far = std::abs(s);
  return srgb_of({0.96 - 0.46 * far, s > 0.0 ? 0.09 * far : -0.045 * far,
                  s > 0.0 ? 0.105 * far : -0.135 * far});
}

std::string css(const Colour& colour) {
  const auto byte = [](float value) { return int(std::lround(255.0f * value)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

}  // namespace hada
