#pragma once

#include <string>

#include "studio/fold_session.h"

namespace hada {

/// What the page must know to draw the sheet: "fold_state/1" of docs/studio.md.
std::string fold_state_text(const FoldSession& session);

/// What the page must know while a face is turned: its places and strain, and by how many degrees.
std::string fold_drag_text(const FoldSession& session);
std::string fold_shape_text(const FoldState& state, double degrees);

/// What the page shows when a face is taken; `turns_view`: the view should turn first.
std::string fold_grip_text(const Grip& grip, bool turns_view);

/// What the page shows while a stroke is drawn; "null" if the pointer means no place.
std::string fold_aim_text(const std::optional<Aim>& aim);

}  // namespace hada
