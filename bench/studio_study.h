#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace hada {

/// How the studio answers a hand that turns a much folded sheet.
struct DragFigures {
  int faces = 0;
  double drag_ms = 0.0, aim_ms = 0.0;  // medians over 40 moves, request to whole answer
  double strain_dragging = 0.0;        // largest of any edge, in any of the answers
  double strain_released = 0.0;
};

/// The crane of `folds` with more creases, one of its faces turned by requests over a socket.
DragFigures study_drag(const std::filesystem::path& folds);

struct PreviewFigures {
  std::vector<std::pair<std::string, double>> material_ms;  // the median of new values of a field
  double other_folds_ms = 0.0;                              // of steel: another sequence
};

/// Every material at 512 x 512, request to whole answer, while the slider of a field moves.
PreviewFigures study_previews();

struct HostileFigures {
  int tried = 0;
  int succeeded = 0;
  bool alive = false;  // our own page is answered afterwards
};

/// Requests without the token, from other hosts and pages, for files beyond the folder, of sizes
/// and forms that are refused.
HostileFigures study_hostile();

/// From the start of `program` to the last byte of the page, s.
double seconds_to_page(const std::filesystem::path& program);

}  // namespace hada
