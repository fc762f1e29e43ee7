#pragma once

#include <string>
#include <vector>

#include "sheet/flat_fold.h"
#include "sheet/fold_log.h"

/// How the steps of a log bring a sheet to lie flat, and keep what is known of its layers.
namespace hada {

/// Folds that were left open become mountains or valleys as the layers lie, and all places those of
/// the flat state.
void settle_folds(FoldState& state, const FlatState& flat);

/// A flat state is placed by its first face; here it is moved so that `face` lies where it does.
void keep_in_place(FlatState& flat, const Sheet& sheet, int face);

/// Folds flat all that is folded and orders the layers, so that known orders hold; face `staying`
/// does not move.
/// returns  why the layers block each other; nothing, and a new state, if they do not
/// throws   Error with `where` if the paper would tear
std::string blocked_flat(FoldState& state, const std::string& where, int staying,
                         const std::vector<FaceOrder>& known);

/// The same without known orders.
/// throws  Error with `where` also if the layers block each other
void flatten(FoldState& state, const std::string& where, int staying = 0);

/// After a movement: the orders of faces that lie on each other now, folds that are shut, and
/// whether all lies level.
///
/// shortly_before  where vertices were when what came together was still apart
void settle_moved(FoldState& state, const std::vector<Eigen::Vector3d>& shortly_before);

/// What is wrong with the order of layers of a flat state: faces that lie on each other and have
/// none, or an order in which paper would pass through paper. Nothing if all is well.
std::string order_flaw(const FoldState& state);

}  // namespace hada
