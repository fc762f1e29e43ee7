// hada_bench_fold DATA: crease patterns and sheets of the collection in DATA/fold, against what
// others found.
#include <cstdio>
#include <filesystem>

#include "bench/fold_study.h"

int main(int argc, char** argv) {
  if (argc < 2 || !std::filesystem::exists(std::filesystem::path(argv[1]) / "fold")) {
    std::fprintf(stderr, "usage: hada_bench_fold DATA, a folder that holds fold/\n");
    return 2;
  }
  const std::filesystem::path data = argv[1];
  for (const auto& score : hada::score_patterns(data)) {
    std::printf("%-45s %4d faces  geometry %.1e  states %s of %s  %.1f ms\n", score.name.c_str(),
                score.faces, score.geometry_error, score.states.c_str(),
                score.states_published.c_str(), score.milliseconds);
  }
  for (const auto& rejection : hada::score_unfoldable(data)) {
    std::printf("%-45s %s\n", rejection.name.c_str(), rejection.reason.c_str());
  }
  return 0;
}
