#include "app/draw/motion_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/draw/lettering.h"
#include "app/draw/lines.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr Colour paper{1.0f, 1.0f, 1.0f}, ink{0.05f, 0.05f, 0.05f}, grid{0.86f, 0.86f, 0.86f},
    data{0.10f, 0.16f, 0.33f}, limit{0.90f, 0.45f, 0.10f};
constexpr int rows = 360, cols = 640, left = 92, right = 20, top = 40, bottom = 56;

}  // namespace

Image motion_picture(const std::vector<double>& motion, double still) {
  Image picture(rows, cols, 3);
  fill_box(picture, 0, 0, rows, cols, paper);
  const auto [least, most] = std::minmax_element(motion.begin(), motion.end());
  const double low = std::floor(std::log10(std::max(std::min(*least, still), 1e-12)));
  const double high = std::max(std::ceil(std::log10(*most)), low + 1.0);
  const double steps = double(motion.size());
  const double spacing = steps <= 60.0    ? 10.0
                         : steps <= 150.0 ? 20.0
                                          : std::ceil(steps / 600) * 100;
  const double last = spacing * std::ceil(steps / spacing);
  const auto x = [&](double step) { return left + step / last * (cols - left - right); };
  const auto y = [&](double value) {
    return rows - bottom - (std::log10(value) - low) / (high - low) * (rows - top - bottom);
  };
  for (double decade = low; decade <= high; decade += 1.0) {
    const double at = y(std::pow(10.0, decade));
    draw_line(picture, {double(left), at}, {double(cols - right), at}, 0.5, grid);
    write_letters(picture, int(at) - 5, 40, fmt::format("10^{:g}", decade), ink);
  }
  for (double step = 0.0; step <= last; step += spacing) {
    draw_line(picture, {x(step), double(top)}, {x(step), double(rows - bottom)}, 0.5, grid);
    write_letters(picture, rows - bottom + 10, int(x(step)) - 8, fmt::format("{:g}", step), ink);
  }
  draw_line(picture, {double(left), y(still)}, {double(cols - right), y(still)}, 0.9, limit);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const Vector2d here(x(double(k + 1)), y(std::max(motion[k], std::pow(10.0, low))));
    draw_line(picture, here, here, 2.0, data);
  }
  write_letters(picture, 14, 12, "motion in a step / wale", ink);
  write_letters(picture, rows - 24, cols / 2 - 10, "step", ink);
  return picture;
}

}  // namespace hada
