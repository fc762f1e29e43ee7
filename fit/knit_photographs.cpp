#include "fit/knit_photographs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "fit/knit_refine.h"
#include "fit/knit_track.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr double seen_likeness = 0.5;    // of a crossing that counts
constexpr double found_likeness = 0.75;  // of all of a photograph, on the average
// Crossings off the model, rms over a wale: stitches are uneven by 2 %, and those that were taken
// for their neighbours by several times that.
constexpr double most_off = 0.03;

/// Where crossings may be in a photograph, and how alike their stitches are there.
struct Placed {
  BentKnit bent;
  double likeness = -1.0;
};

/// What a piece may look like when it is pulled, before anything is known of it.
struct Hypothesis {
  int first;  // entry of the repeat that the lowest course is of
  double ratio, continuity;
  std::vector<Places> places = {};  // of each photograph, about its middle
  std::vector<Placed> placed = {};  // in each photograph, where it fits best
  double score = 0.0;
};

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

std::vector<Hypothesis> hypotheses(const KnitNet& net, const std::vector<int>& repeat,
                                   const std::vector<KnitPhotograph>& photographs,
                                   KnitClamp clamp) {
  std::vector<Hypothesis> all;
  for (int first = 0; first < int(repeat.size()); ++first) {
    for (const double ratio : {0.08, 0.3, 1.0, 3.5, 12.0, 40.0}) all.push_back({first, ratio, 0.2});
  }
  for_each_index(int(all.size()), [&](int k) {
    Hypothesis& h = all[std::size_t(k)];
    for (const auto& photograph : photographs) {
      auto knit = pulled(net, photograph.pull, clamp, photograph.stretch);
      knit.net.stiffness =
          stiffness_of_courses(net.courses, h.ratio, turned_repeat(repeat, h.first));
      knit.net.continuity = h.continuity;
      auto rest = knit_at_rest(knit.net, knit.start);
      h.places.push_back(rest.settled ? std::move(rest.places) : Places());
    }
  });
  return all;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / double(std::max<std::size_t>(values.size(), 1));
}

/// The best of `places`, turned, at shifts of a quarter of a stitch, then of a twelfth.
Placed placed(const Levels& levels, const KnitNet& net, const Places& places, int first,
              double turn) {
  const auto samples = int(levels.looks[0].courses[0].size());
  // Some thousand samples in all, a dozen of a stitch at least.
  const int of_stitch = std::max(12, 4000 / net.points());
  const int stride = std::max(1, samples / of_stitch) | 1;
  Placed best;
  const auto search = [&](const Eigen::Vector2d& middle, int shifts, double step) {
    Eigen::Vector2d found = middle;
    for (int y = -shifts; y <= shifts; ++y) {
      for (int x = -shifts; x <= shifts; ++x) {
        const Eigen::Vector2d at = middle + step * Eigen::Vector2d(x, y);
        const Vector3d shift(at.x() * net.wale_length, at.y() * net.course_length, 0.0);
        BentKnit bent{net.courses, net.wales, places};
        for (auto& p : bent.places) {
          p = Vector3d(std::cos(turn) * p.x() - std::sin(turn) * p.y(),
                       std::sin(turn) * p.x() + std::cos(turn) * p.y(), 0.0) +
              shift;
        }
        const double likeness =
            mean_of(likeness_at(levels.pictures[0], levels.looks[0], bent, first, stride));
        if (likeness > best.likeness) best = {std::move(bent), likeness}, found = at;
      }
    }
    return found;
  };
  search(search(Eigen::Vector2d::Zero(), 5, 0.25), 1, 1.0 / 12.0);
  return best;
}

constexpr double degree = std::numbers::pi / 180.0;

/// The best of `places` at some turns.
Placed placed_and_turned(const Levels& levels, const KnitNet& net, const Places& places,
                         int first) {
  Placed best;
  for (const double turn : {0.0, -1.5, 1.5, -3.0, 3.0}) {
    Placed one = placed(levels, net, places, first, turn * degree);
    if (one.likeness > best.likeness) best = std::move(one);
  }
  return best;
}

/// The hypotheses that begin with a course, those first that are most like all photographs: all
/// unturned, then the few best of them turned.
std::vector<Hypothesis> ranked(const std::vector<Hypothesis>& all, int first,
                               const std::vector<Levels>& levels, const KnitNet& net) {
  constexpr std::size_t worth_turning = 3;
  std::vector<Hypothesis> some;
  for (const Hypothesis& h : all) {
    const bool rests = std::none_of(h.places.begin(), h.places.end(),
                                    [](const Places& places) { return places.empty(); });
    if (h.first == first && rests) some.push_back(h);
  }
  const auto better = [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; };
  for (Hypothesis& h : some) {
    for (std::size_t s = 0; s < levels.size(); ++s) {
      h.score += placed(levels[s], net, h.places[s], first, 0.0).likeness;
    }
  }
  std::stable_sort(some.begin(), some.end(), better);
  some.resize(std::min(some.size(), worth_turning));
  for (Hypothesis& h : some) {
    h.score = 0.0;
    for (std::size_t s = 0; s < levels.size(); ++s) {
      h.placed.push_back(placed_and_turned(levels[s], net, h.places[s], first));
      h.score += h.placed.back().likeness;
    }
  }
  std::stable_sort(some.begin(), some.end(), better);
  return some;
}

/// Where the crossings of each photograph are, as far as a hypothesis leads to them.
struct Attempt {
  int first = 0;
  std::vector<RefinedCrossings> crossings;
  double likeness = -1.0;  // of the worst photograph
};

Attempt attempt(const Hypothesis& h, const std::vector<Levels>& levels, const Knit<>& knit,
                const std::vector<KnitPhotograph>& photographs) {
  Knit<> piece = knit;
  for (std::size_t k = 0; k < piece.colour_repeat.size(); ++k) {
    piece.colour_repeat[k] =
        knit.colour_repeat[(k + std::size_t(h.first)) % knit.colour_repeat.size()];
  }
  Attempt found{h.first, {}, 1.0};
  for (std::size_t s = 0; s < levels.size(); ++s) {
    const BentKnit bent = tracked(levels[s].pictures, levels[s].looks, h.placed[s].bent, h.first);
    found.crossings.push_back(refined(photographs[s].picture, piece, bent));
    found.likeness = std::min(found.likeness, mean_of(found.crossings.back().likeness));
  }
  return found;
}

Attempt best_attempt(const Surface& rest, const Knit<>& knit, const std::vector<int>& repeat,
                     const std::vector<KnitPhotograph>& photographs, const KnitNet& net,
                     KnitClamp clamp) {
  constexpr double clear = 0.9;  // likeness that needs no further attempt
  std::vector<Levels> levels;
  for (const auto& photograph : photographs) {
    levels.push_back(levels_of(rest, knit, photograph.picture));
  }
  const auto all = hypotheses(net, repeat, photographs, clamp);
  std::vector<std::vector<Hypothesis>> order;
  for (int first = 0; first < int(repeat.size()); ++first) {
    order.push_back(ranked(all, first, levels, net));
  }
  // A piece that is begun with the wrong course fits all but its border one course further: the
  // best of each beginning is followed to its end, then, if none is clear, the next best.
  Attempt best;
  for (std::size_t place = 0; place < 2 && best.likeness < clear; ++place) {
    for (const auto& of_beginning : order) {
      if (place >= of_beginning.size()) continue;
      Attempt one = attempt(of_beginning[place], levels, knit, photographs);
      if (one.likeness > best.likeness) best = std::move(one);
    }
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
