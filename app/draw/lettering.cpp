#include "app/draw/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace hada {
namespace {

constexpr int letter_rows = 5, letter_cols = 3;

// Five rows of three points each, the uppermost first.
const std::map<char, std::array<int, letter_rows>>& letters() {
  static const std::map<char, std::array<int, letter_rows>> known{
      {'0', {7, 5, 5, 5, 7}}, {'1', {2, 6, 2, 2, 7}}, {'2', {7, 1, 7, 4, 7}},
      {'3', {7, 1, 7, 1, 7}}, {'4', {5, 5, 7, 1, 1}}, {'5', {7, 4, 7, 1, 7}},
      {'6', {7, 4, 7, 5, 7}}, {'7', {7, 1, 2, 2, 2}}, {'8', {7, 5, 7, 5, 7}},
      {'9', {7, 5, 7, 1, 7}}, {'.', {0, 0, 0, 0, 2}}, {'-', {0, 0, 7, 0, 0}},
      {'/', {1, 1, 2, 4, 4}}, {'^', {2, 5, 0, 0, 0}}, {'m', {0, 7, 7, 5, 5}},
      {'k', {4, 5, 6, 6, 5}}, {'P', {7, 5, 7, 4, 4}}, {'a', {0, 3, 5, 5, 3}},
      {'N', {5, 7, 7, 5, 5}}, {'e', {3, 5, 7, 4, 3}}, {'+', {0, 2, 7, 2, 0}},
      {'%', {5, 1, 2, 4, 5}}, {'c', {0, 3, 4, 4, 3}}, {'f', {1, 2, 7, 2, 2}},
      {'h', {4, 4, 6, 5, 5}}, {'i', {2, 0, 2, 2, 2}}, {'l', {6, 2, 2, 2, 7}},
      {'n', {0, 6, 5, 5, 5}}, {'o', {0, 2, 5, 5, 2}}, {'p', {0, 6, 5, 6, 4}},
      {'s', {0, 3, 2, 1, 6}}, {'t', {2, 7, 2, 2, 1}}, {'w', {0, 5, 5, 7, 7}}};
  return known;
}

}  // namespace

void fill_box(Image& picture, int row, int col, int rows, int cols, const Colour& colour) {
  const auto& first = picture.planes[0];
  for (int r = std::max(row, 0); r < std::min(row + rows, first.rows()); ++r) {
    for (int c = std::max(col, 0); c < std::min(col + cols, first.cols()); ++c) {
      for (std::size_t p = 0; p < 3; ++p) picture.planes[p](r, c) = colour[p];
    }
  }
}

int write_letters(Image& picture, int row, int col, const std::string& text, const Colour& colour,
                  int size) {
  const int start = col;
  for (const char letter : text) {
    const auto known = letters().find(letter);
    for (int r = 0; known != letters().end() && r < letter_rows; ++r) {
      for (int c = 0; c < letter_cols; ++c) {
        if ((known->second[std::size_t(r)] >> (letter_cols - 1 - c)) % 2 == 0) continue;
        fill_box(picture, row + size * r, col + size * c, size, size, colour);
      }
    }
    col += size * (letter_cols + 1);
  }
  return col - start;
}

void draw_scale_bar(Image& picture, double pitch_mm, const Colour& colour) {
  const int rows = picture.planes[0].rows(), cols = picture.planes[0].cols();
  const double most = 0.3 * cols * pitch_mm, decade = std::pow(10.0, std::floor(std::log10(most)));
  double length = decade;
  for (const double digit : {2.0, 5.0}) {
    if (digit * decade <= most) length = digit * decade;
  }
  fill_box(picture, rows - 12, 8, 3, int(std::lround(length / pitch_mm)), colour);
  write_letters(picture, rows - 26, 8, fmt::format("{:g} mm", length), colour);
}

void draw_colour_bar(Image& picture, double low, double high, const std::string& unit,
                     const Colour& colour) {
  const int rows = picture.planes[0].rows(), cols = picture.planes[0].cols();
  const int top = 24, height = std::max(rows / 3, 40), left = cols - 70;
  for (int r = 0; r < height; ++r) {
    fill_box(picture, top + r, left, 1, 12, sequential(1.0 - double(r) / (height - 1)));
  }
  write_letters(picture, top, left + 16, fmt::format("{:.3g}", high), colour);
  write_letters(picture, top + height - 10, left + 16, fmt::format("{:.3g}", low), colour);
  write_letters(picture, 8, left, unit, colour);
}

}  // namespace hada
