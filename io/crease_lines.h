#pragma once

#include <string>

#include "core/fold.h"

namespace hada {

/// Crease patterns of formats that know single lines only: vertices are shared by no two lines, and
/// lines may cross. `where` is the name of the file, for Errors.

/// `.cp` (ORIPA): a line of five numbers for each crease: kind, x1, y1, x2, y2. Kinds: 1 border,
/// 2 mountain, 3 valley, 0 and 4 flat.
FoldFrame lines_of_cp(const std::string& text, const std::string& where);

/// `.opx` (ORIPA): Java beans in XML with the properties type, x0, y0, x1, y1.
FoldFrame lines_of_opx(const std::string& text, const std::string& where);

/// `.svg`: line, polyline, polygon, rect and straight paths, moved by their transforms. Red is a
/// mountain, blue a valley, black the border, yellow a facet edge, green a cut, magenta
/// unassigned; an opacity of 0.5 stands for a fold by 90 degrees. Other colours are passed over.
FoldFrame lines_of_svg(const std::string& text, const std::string& where);

}  // namespace hada
