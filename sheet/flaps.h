#pragma once

#include <string>
#include <vector>

#include "sheet/crease.h"
#include "sheet/sheet.h"

namespace hada {

/// The faces to the left of creases, as far as paper hangs together without crossing them.
///
/// cut     what the creases were drawn by: says where left is
/// throws  Error with `where` if there are no creases, or they do not part the paper
std::vector<bool> moving_faces(const Sheet& sheet, const std::vector<int>& creases,
                               const CreaseCut& cut, const std::string& where);

/// The flaps that creases part off among the moving faces, numbered from 0; -1 for faces that stay.
std::vector<int> flaps_of(const Sheet& sheet, const std::vector<bool>& moving,
                          const std::vector<int>& creases);

/// The flap of a level sheet that no other covers on this side: one that covers others if there is
/// one, and of several the one that is furthest out; -1 if there is none.
///
/// side  1 seen from above, -1 from below
int outermost_flap(const Sheet& sheet, const std::vector<FaceOrder>& order,
                   const std::vector<int>& flap, int side);

}  // namespace hada
