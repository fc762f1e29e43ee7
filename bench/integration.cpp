// hada_bench_integration [largest size]: integration side by side with solvers that others wrote,
// those whose libraries were found. Times are of the processor, on one thread, and of this run
// alone.
// hada_bench_integration sigma size: at how many pixels the sigma of the height is right.
// hada_bench_integration disk size folder: one integration with all maps in files in the folder.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/integration_study.h"

namespace {

void print(const hada::SolverRun& run, const hada::SolverRun& ours, double pass) {
  std::printf("%5d  %-42s %9.4f s %8.0f passes  %7.1f x hada  %.2g px rms", run.size,
              run.solver.c_str(), run.seconds, run.seconds / pass, run.seconds / ours.seconds,
              run.error_px);
  if (run.cycles > 0) std::printf("  %d cycles", run.cycles);
  if (run.megabytes > 0.0) {
    std::printf("  %.0f MB, %.1f B/px", run.megabytes,
                run.megabytes * 0x1p20 / run.size / run.size);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "sigma") {
    std::printf("%.1f %% of the pixels\n", 100.0 * hada::share_of_good_sigmas(std::atoi(argv[2])));
    return 0;
  }
  if (argc > 3 && std::string(argv[1]) == "disk") {
    const double pass = hada::one_pass_seconds(4096);
    const auto run = hada::run_on_disk(hada::MaskKind::irregular, std::atoi(argv[2]), argv[3]);
    print(run, run, pass * run.size / 4096.0 * run.size / 4096.0);
    return 0;
  }
  const int largest = argc > 1 ? std::atoi(argv[1]) : 4096;
  for (int size = 1024; size <= largest; size *= 2) {
    const double pass = hada::one_pass_seconds(size);
    std::printf("one pass over %d x %d floats: %.2f ms\n", size, size, 1e3 * pass);
    for (const auto kind :
         {hada::MaskKind::irregular, hada::MaskKind::slits, hada::MaskKind::full}) {
      const auto scene = hada::integration_scene(kind, size);
      const hada::SolverRun ours = hada::run_ours(scene, 5);
      std::printf("%s\n", kind == hada::MaskKind::full    ? "full square"
                          : kind == hada::MaskKind::slits ? "slits"
                                                          : "irregular mask");
      print(ours, ours, pass);
      print(hada::run_ours(scene, 5, 2), ours, pass);
      if (kind == hada::MaskKind::full) {
        for (const auto& run : hada::run_peers(scene)) print(run, ours, pass);
      } else if (kind == hada::MaskKind::irregular && size <= 1024) {
        print(hada::run_eigen_cg(scene), ours, pass);
        for (const auto& run : hada::run_peers(scene)) print(run, ours, pass);
      }
    }
  }
  return 0;
}
