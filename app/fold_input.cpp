#include "app/fold_input.h"

#include <algorithm>

#include "io/fold_file.h"
#include "sheet/unfold.h"

namespace hada {
namespace {

bool is_flat(const FoldFrame& frame) {
  return !frame.edges.empty() && std::all_of(frame.vertices.begin(), frame.vertices.end(),
                                             [](const Eigen::Vector3d& p) { return p.z() == 0.0; });
}

bool is_folded_form(const FoldFrame& frame) {
  return std::find(frame.classes.begin(), frame.classes.end(), "foldedForm") != frame.classes.end();
}

}  // namespace

Sheet read_sheet(const std::filesystem::path& path, std::string* title) {
  const FoldFile file = read_crease_pattern(path);
  if (title != nullptr) *title = file.title;
  const FoldFrame* flat = nullptr;
  const FoldFrame* folded = nullptr;
  for (const FoldFrame& frame : file.frames) {
    if (flat == nullptr && is_flat(frame) && !is_folded_form(frame)) flat = &frame;
    if (folded == nullptr && is_folded_form(frame)) folded = &frame;
  }
  if (flat == nullptr && folded != nullptr) {
    return unfolded_sheet(*folded, path.string());
  }
  const FoldFrame& key = flat == nullptr ? file.frames[0] : *flat;
  Sheet sheet = sheet_of(key, path.string());
  if (folded != nullptr && folded->vertices.size() == sheet.folded.size()) {
    sheet.folded = folded->vertices;
  }
  return sheet;
}

}  // namespace hada
