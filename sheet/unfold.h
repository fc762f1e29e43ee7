#pragma once

#include <string>

#include "sheet/sheet.h"

namespace hada {

/// The sheet whose folded form is `frame`: its faces are laid flat one beside the other.
///
/// Faces are reached from the first along a shortest chain of neighbours. A vertex that several
/// chains reach lies at the mean of what they say. Where the frame has no faces, those that its
/// edges enclose seen from above are taken.
///
/// throws  Error with `where` if the frame has no faces, or the sheet would fall into parts
Sheet unfolded_sheet(const FoldFrame& frame, const std::string& where);

}  // namespace hada
