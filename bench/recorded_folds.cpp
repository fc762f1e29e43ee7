#include "bench/recorded_folds.h"

#include <algorithm>
#include <filesystem>

#include "app/fold_log_file.h"
#include "sheet/crossing.h"
#include "sheet/folded_flat.h"

namespace hada {

std::vector<RecordedFold> recorded_folds() {
  const auto folder = std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic" / "folds";
  std::vector<RecordedFold> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const FoldLog log = read_fold_log(entry.path());
    const auto states = replayed(log), again = replayed(log);
    RecordedFold fold;
    fold.title = log.title;
    fold.steps = int(log.steps.size());
    fold.faces = states.back().sheet.faces();
    fold.same = states.back().sheet.folded == again.back().sheet.folded &&
                states.back().order == again.back().order;
    for (const FoldState& state : states) {
      fold.piercing += int(crossing_faces(state.sheet, 1e-6 * log.side).size());
      fold.flat_states += state.flat;
      fold.ordered_states += state.flat && order_flaw(state).empty();
      fold.contacts += state.contact.has_value();
    }
    all.push_back(std::move(fold));
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.title < b.title; });
  return all;
}

}  // namespace hada
