#pragma once

#include <string>

#include "app/draw/palette.h"
#include "core/image.h"

namespace hada {

/// Writes small plain letters into a picture, their upper left corner at (row, col); what lies
/// outside is left out. Digits, ". - / ^" and the letters of units are known, the rest stays blank.
///
/// returns  the columns that were written
int write_letters(Image& picture, int row, int col, const std::string& text, const Colour& colour,
                  int size = 2);

/// Fills a rectangle.
void fill_box(Image& picture, int row, int col, int rows, int cols, const Colour& colour);

/// A bar as long as a round number of mm, with its length, in the lower left corner.
void draw_scale_bar(Image& picture, double pitch_mm, const Colour& colour);

/// The colours of `sequential` from `low` to `high` up the right border, with both numbers and a
/// unit.
void draw_colour_bar(Image& picture, double low, double high, const std::string& unit,
                     const Colour& colour);

}  // namespace hada
