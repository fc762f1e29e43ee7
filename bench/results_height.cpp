#include "bench/results_height.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bench/integration_study.h"
#include "bench/results_page.h"

namespace hada {
namespace {

void say(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
}

std::string figure(const std::string& name, const std::string& asked, const std::string& measured,
                   bool met) {
  return row({name, asked, measured, verdict(met)});
}

// How many times as long another solver takes.
std::string against(const SolverRun& peer, const SolverRun& ours, double least) {
  const double times = peer.seconds / ours.seconds;
  return figure(fmt::format("against {}, {} x {}", peer.solver, ours.size, ours.size),
                fmt::format(">= {:.0f} x", least),
                fmt::format("{:.1f} x: {:.3f} s, {:.3f} s", times, peer.seconds, ours.seconds),
                times >= least);
}

std::string irregular_masks() {
  std::string page;
  double conjugate_gradients = 0.0;
  for (const int size : {1024, 2048}) {
    say(fmt::format("height: solvers of others, {} x {}", size, size));
    const auto scene = integration_scene(MaskKind::irregular, size);
    auto ours = run_ours(scene, 9);
    std::vector<SolverRun> peers;
    if (size == 1024) {
      peers.push_back(run_eigen_cg(scene));
      conjugate_gradients = peers.front().seconds;
    } else {
      // Four times the pixels, twice the iterations; measuring it would take many minutes.
      peers.push_back(
          {"Eigen, conjugate gradients (8 x its time at 1024)", size, 8.0 * conjugate_gradients});
    }
    for (auto& peer : run_peers(scene)) {
      if (peer.solver.starts_with("hypre")) peers.push_back(std::move(peer));
    }
    // Once more after the others: what a machine allows changes within a minute.
    ours.seconds = 0.5 * (ours.seconds + run_ours(scene, 9).seconds);
    for (const auto& peer : peers) {
      page += against(peer, ours, peer.solver.starts_with("hypre") ? 100.0 : 1000.0);
    }
  }
  say("height: 4096 x 4096");
  const auto scene = integration_scene(MaskKind::irregular, 4096);
  const double pass = one_pass_seconds(4096);
  const auto one = run_ours(scene, 5);
  const auto two = run_ours(scene, 5, 2);
  const double per_pixel = one.megabytes * 0x1p20 / 4096.0 / 4096.0;
  page += figure("irregular mask, 4096 x 4096, one thread", "<= 180 passes",
                 fmt::format("{:.0f} passes, {:.3f} s", one.seconds / pass, one.seconds),
                 one.seconds <= 180.0 * pass);
  page += figure("the same on two threads, on the wall", "goal: <= 100 passes",
                 fmt::format("{:.0f} passes, {:.3f} s", two.seconds / pass, two.seconds),
                 two.seconds <= 100.0 * pass);
  page += figure("its error, rms", "<= 1e-4 px", fmt::format("{:.1e} px", one.error_px),
                 one.error_px <= 1e-4);
  page += figure("its memory beside slopes and mask", "<= 40 B/px",
                 fmt::format("{:.1f} B/px", per_pixel), per_pixel <= 40.0);
  return page + figure("the same bytes on one and on two threads", "yes",
                       same_at_two_threads(scene) ? "yes" : "no", same_at_two_threads(scene));
}

std::string rectangles() {
  say("height: rectangle");
  const auto scene = integration_scene(MaskKind::full, 4096);
  const auto ours = run_ours(scene, 5);
  std::string page;
  for (const auto& peer : run_peers(scene)) page += against(peer, ours, 2.0);
  return page;
}

std::string cycles() {
  say("height: cycles");
  constexpr int size = 1024;
  const auto plain_scene = integration_scene(MaskKind::irregular, size);
  const auto plain = run_ours(plain_scene, 1);
  std::string page;
  const auto add = [&](const std::string& name, const SolverRun& run) {
    page += figure(name, fmt::format("<= 1.5 x the {} of the irregular mask", plain.cycles),
                   fmt::format("{} cycles, {:.1e} px", run.cycles, run.error_px),
                   run.cycles <= 1.5 * plain.cycles);
  };
  for (const int slit_size : {1024, 4096}) {
    add(fmt::format("slits 2 px wide, {} x {}", slit_size, slit_size),
        run_ours(integration_scene(MaskKind::slits, slit_size), 1));
  }
  for (const auto& [kind, name] :
       {std::pair(WeightKind::equal, "equal weights"),
        std::pair(WeightKind::smooth, "weights in waves from 1e-6 to 1"),
        std::pair(WeightKind::disc, "a disc of weight 1e-6"),
        std::pair(WeightKind::random, "weights from 1e-6 to 1, pixel by pixel")}) {
    add(name, run_weighted(plain_scene, kind));
  }
  return page;
}

std::string sigmas() {
  std::string page;
  for (const int size : {400, 800}) {  // with all pixels, and on a coarser lattice
    say(fmt::format("height: sigma, {} x {}", size, size));
    const double share = share_of_good_sigmas(size);
    page += figure(fmt::format("sigma of the height within 15 % of 200 draws, {} x {}", size, size),
                   ">= 90 % of the pixels", fmt::format("{:.1f} %", 100.0 * share), share >= 0.9);
  }
  return page;
}

}  // namespace

std::string height_results() {
  return table("Normals to height: processor time on one thread, setup included",
               "| figure | must be | measured | |") +
         irregular_masks() + rectangles() + cycles() + sigmas() +
         "\nA pass reads an array of floats of that size once. Our times are medians; beside those "
         "of others, of runs before and after.\n";
}

}  // namespace hada
