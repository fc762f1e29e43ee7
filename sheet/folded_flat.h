#pragma once

#include <string>

#include "sheet/flat_fold.h"
#include "sheet/fold_log.h"

/// How the steps of a log bring a sheet to lie flat, and keep what is known of its layers.
namespace hada {

/// Folds that were left open become mountains or valleys as the layers lie, and all places those of
/// the flat state.
void settle_folds(FoldState& state, const FlatState& flat);

/// A flat state is placed by its first face; here it is moved so that `face` lies where it does.
void keep_in_place(FlatState& flat, const Sheet& sheet, int face);

/// Folds flat all that is folded and orders the layers; face `staying` does not move.
/// throws  Error with `where` if the paper would tear, or its layers block each other
void flatten(FoldState& state, const std::string& where, int staying = 0);

/// After faces were cut: they lie over others as the whole did; the parts of one do not overlap.
void split_orders(FoldState& state, int faces_before);

}  // namespace hada
