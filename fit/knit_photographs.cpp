#include "fit/knit_photographs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "fit/knit_refine.h"
#include "fit/knit_search.h"
#include "fit/knit_track.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

constexpr double seen_likeness = 0.5;    // of a crossing that counts
constexpr double found_likeness = 0.75;  // of all of a photograph, on the average
// Crossings off the model, rms over a wale: stitches are uneven by 2 %, and those that were taken
// for their neighbours by several times that.
constexpr double most_off = 0.03;

/// A photograph in two smoothings, and the look of stitches in each.
struct Levels {
  std::vector<TrackedPicture> pictures;
  std::vector<StitchLook> looks;
};

Levels levels_of(const Surface& rest, const Knit<>& knit, const Surface& picture) {
  constexpr double smooth = 0.12, sharp_px = 0.7;  // of a wale; of a pixel
  Levels levels;
  for (const double px : {smooth * knit.wale_mm / picture.extent.pitch, sharp_px}) {
    levels.pictures.push_back(tracked_picture(picture, px));
    levels.looks.push_back(
        look_of(tracked_picture(rest, px * picture.extent.pitch / rest.extent.pitch), knit));
  }
  return levels;
}

std::vector<int> turned_repeat(const std::vector<int>& repeat, int first) {
  std::vector<int> turned = repeat;
  std::rotate(turned.begin(), turned.begin() + first % int(repeat.size()), turned.end());
  return turned;
}

KnitNet piece_at_rest(const Knit<>& knit, const KnitPiece& piece) {
  KnitNet net;
  net.courses = piece.courses, net.wales = piece.wales;
  net.wale_length = knit.wale_mm, net.course_length = knit.course_mm;
  return net;
}

/// The rests of a piece that begins with a course, pulled as in a photograph.
PulledShapes shapes_of(KnitNet net, const std::vector<int>& repeat, KnitClamp clamp,
                       const KnitPhotograph& photograph) {
  const std::vector<double> ratios{0.08, 0.3, 1.0, 3.5, 12.0, 40.0};
  std::vector<KnitAtRest> rests(ratios.size());
  for_each_index(int(ratios.size()), [&](int k) {
    auto knit = pulled(net, photograph.pull, clamp, photograph.stretch);
    knit.net.stiffness = stiffness_of_courses(net.courses, ratios[std::size_t(k)], repeat);
    rests[std::size_t(k)] = knit_at_rest(knit.net, knit.start);
  });
  PulledShapes shapes;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    if (!rests[k].settled) continue;
    shapes.log_ratios.push_back(std::log(ratios[k]));
    shapes.places.push_back(std::move(rests[k].places));
  }
  return shapes;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / double(std::max<std::size_t>(values.size(), 1));
}

/// Where a piece that begins with a course lies in each photograph.
struct Beginning {
  int first = 0;  // entry of the repeat that the lowest course is of
  std::vector<std::vector<PlacedKnit>> placed = {};  // in each photograph, best first
};

std::vector<Beginning> beginnings(const std::vector<Levels>& levels, const KnitNet& net,
                                  const std::vector<int>& repeat,
                                  const std::vector<KnitPhotograph>& photographs, KnitClamp clamp) {
  std::vector<Beginning> all;
  for (int first = 0; first < int(repeat.size()); ++first) {
    Beginning one{first};
    for (std::size_t s = 0; s < levels.size(); ++s) {
      const auto shapes = shapes_of(net, turned_repeat(repeat, first), clamp, photographs[s]);
      one.placed.push_back(
          placements(levels[s].pictures[0], levels[s].looks[0], net, shapes, first));
    }
    all.push_back(std::move(one));
  }
  return all;
}

/// Where the crossings of each photograph are, as far as a beginning leads to them.
struct Attempt {
  int first = 0;
  std::vector<RefinedCrossings> crossings;
  double likeness = -1.0;  // of the worst photograph
};

Attempt attempt(const Beginning& beginning, const std::vector<Levels>& levels, const Knit<>& knit,
                const std::vector<KnitPhotograph>& photographs) {
  // Places that are less alike by this are not followed.
  constexpr double worth_following = 0.1;
  constexpr double clear = 0.9;  // likeness that needs no further attempt
  constexpr std::size_t most_followed = 3;
  Knit<> piece = knit;
  std::rotate(piece.colour_repeat.begin(),
              piece.colour_repeat.begin() + beginning.first % int(piece.colour_repeat.size()),
              piece.colour_repeat.end());
  Attempt found{beginning.first, {}, 1.0};
  for (std::size_t s = 0; s < levels.size(); ++s) {
    RefinedCrossings best;
    double likeness = -1.0;
    const auto& placed = beginning.placed[s];
    for (std::size_t k = 0; k < std::min(placed.size(), most_followed) && likeness < clear; ++k) {
      if (placed[k].likeness < placed[0].likeness - worth_following) break;
      const BentKnit bent =
          tracked(levels[s].pictures, levels[s].looks, placed[k].bent, beginning.first);
      RefinedCrossings one = refined(photographs[s].picture, piece, bent);
      const double alike = mean_of(one.likeness);
      if (alike > likeness) likeness = alike, best = std::move(one);
    }
    found.crossings.push_back(std::move(best));
    found.likeness = std::min(found.likeness, likeness);
  }
  return found;
}

Attempt best_attempt(const Surface& rest, const Knit<>& knit, const std::vector<int>& repeat,
                     const std::vector<KnitPhotograph>& photographs, const KnitNet& net,
                     KnitClamp clamp) {
  std::vector<Levels> levels;
  for (const auto& photograph : photographs) {
    levels.push_back(levels_of(rest, knit, photograph.picture));
  }
  // A piece that is begun with the wrong course fits all but its border one course further: each
  // beginning is followed to its end.
  Attempt best;
  for (const auto& beginning : beginnings(levels, net, repeat, photographs, clamp)) {
    Attempt one = attempt(beginning, levels, knit, photographs);
    if (one.likeness > best.likeness) best = std::move(one);
  }
  return best;
}

}  // namespace

PulledKnitFit fit_photographs(const Surface& rest, const Knit<>& knit,
                              const std::vector<int>& repeat,
                              const std::vector<KnitPhotograph>& photographs,
                              const KnitPiece& piece) {
  if (photographs.empty()) throw Error("give a photograph of the knit pulled");
  PulledKnitFit fit;
  fit.net = piece_at_rest(knit, piece);
  const Attempt found = best_attempt(rest, knit, repeat, photographs, fit.net, piece.clamp);
  fit.repeat = turned_repeat(repeat, found.first);
  for (std::size_t s = 0; s < photographs.size(); ++s) {
    const double likeness = found.crossings.size() > s ? mean_of(found.crossings[s].likeness) : 0.0;
    if (likeness < found_likeness) {
      throw Error(fmt::format(
          "the {} x {} crossings of photograph {} are not found (likeness {:.2f}): check the "
          "numbers of courses and wales, the stretch and the clamps, and that the middle of the "
          "piece is in the middle of the picture",
          piece.courses, piece.wales, s + 1, likeness));
    }
    const auto& crossings = found.crossings[s];
    KnitState state{photographs[s].pull, photographs[s].stretch, crossings.places};
    int unseen = 0;
    for (std::size_t i = 0; i < state.places.size(); ++i) {
      if (crossings.likeness[i] >= seen_likeness) continue;
      state.places[i].setConstant(NAN);
      ++unseen;
    }
    if (unseen > 0) {
      fit.remarks.push_back(
          fmt::format("{} of {} crossings of photograph {} are not seen and left out", unseen,
                      fit.net.points(), s + 1));
    }
    fit.states.push_back(std::move(state));
    fit.likeness.push_back(crossings.likeness);
  }
  fit.stiffness =
      knit_stiffness(fit.net, fit.repeat, piece.clamp, fit.states, {.frame_known = false});
  const double off = fit.stiffness.noise_mm / fit.net.wale_length;
  if (off > most_off) {
    throw Error(fmt::format(
        "the crossings that are found lie {:.1f} % of a wale off those of any knit that is pulled "
        "so: check the numbers of courses and wales, the stretches and the clamps",
        100.0 * off));
  }
  return fit;
}

}  // namespace hada
