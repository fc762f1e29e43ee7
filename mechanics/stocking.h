#pragma once

#include "mechanics/shell_net.h"

namespace hada {

/// How a stocking is knitted, from the welt down to the toe.
struct StockingShape {
  int wales = 60;
  int leg = 40;   // rounds of the leg
  int heel = 12;  // short rows of the heel, an even number; 0: no heel
  int foot = 16;  // rounds of the foot
  int toe = 10;   // rounds of the toe, each of fewer wales than the one before
};

/// A stocking as springs. Wale 0 runs down the middle of the front, wales / 2 down the middle of
/// the back.
///
/// Heel: rows over the back half of the wales, each narrower than the one before until a third is
/// left, then wider again. Where a row turns, its yarn is wrapped around the stitch beside it. The
/// wales at the back are longer by all rows, those at its sides by two of them.
///
/// Toe: rounds of wales * cos(t) stitches, t even from 0 to a right angle, as a hemisphere has
/// them. A wale that ends is knitted together with the one before it. The last round is drawn
/// together in one point, which is the last of the net.
///
/// Points are counted in the order in which they are knitted; lengths, stiffness and pins are not
/// set.
/// throws  Error unless there are 16 wales, 2 rounds of leg and foot and 3 of toe at least, and an
///         even number of heel rows
ShellNet stocking_net(const StockingShape& shape);

}  // namespace hada
