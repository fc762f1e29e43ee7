#include "app/fold_model.h"

#include "sheet/sheet.h"

namespace hada {
namespace {

FoldFrame frame_of(const FoldState& state) {
  FoldFrame frame = folded_frame(state.sheet);
  frame.face_orders = state.order;
  return frame;
}

}  // namespace

FoldFile fold_model(const std::string& title, const FoldState& state) {
  FoldFile file;
  file.title = title;
  file.frames = {frame_of(state), flat_frame(state.sheet)};
  return file;
}

FoldFile fold_sequence(const std::string& title, const std::vector<FoldState>& states) {
  FoldFile file = fold_model(title, states.back());
  for (const FoldState& state : states) file.frames.push_back(frame_of(state));
  return file;
}

}  // namespace hada
