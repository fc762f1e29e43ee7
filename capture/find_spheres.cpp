#include "capture/find_spheres.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "capture/circle.h"
#include "capture/faint_outline.h"
#include "capture/likeness.h"
#include "capture/overview.h"
#include "capture/sphere_geometry.h"
#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

struct Candidate {
  Circle circle;
  SphereKind kind = SphereKind::matte;
  double worth = 0.0;
  bool given = false;  // the circle is the owner's mask
};

Sphere sphere_of(const Circle& circle, SphereKind kind) {
  Sphere sphere;
  sphere.kind = kind;
  sphere.center_px = circle.center;
  sphere.radius_px = circle.radius;
  // Edge points that are independent of each other lie about two pixels apart.
  const double points = std::max(3.0, circle.coverage * 3.0 * circle.radius);
  const double sigma = circle.sigma > 0.0 ? circle.sigma : circle.scatter * std::sqrt(2.0 / points);
  sphere.sigma_px = std::max(0.03, sigma);
  return sphere;
}

bool crosses_frame(const Circle& circle, const Extent& extent) {
  return circle.center.x() < circle.radius || circle.center.y() < circle.radius ||
         circle.center.x() + circle.radius > extent.cols ||
         circle.center.y() + circle.radius > extent.rows;
}

// The outline of a mirror around a circle that was found on or in it. The brightest of all pictures
// shows it best: no shadow lies across, and the mirrored table is a tenth darker all the way round.
// On a backdrop of a few steps of the file only the mean of all pictures shows it clearly.
Circle mirror_outline(const Overview& all, const Circle& circle, std::optional<double> radius_px) {
  const auto brightest = faint_outline(all.brightest_log, circle, radius_px);
  const auto mean = faint_outline(all.mean_log, circle, radius_px);
  constexpr double much_clearer = 0.5;
  if (brightest && !(mean && mean->sigma < much_clearer * brightest->sigma)) return *brightest;
  if (mean) return *mean;
  if (!radius_px) return circle;
  // The circle that was found is an edge inside the mirror, which need not lie in its middle.
  Circle known = circle;
  known.radius = *radius_px;
  known.sigma = std::max(0.5 * std::abs(*radius_px - circle.radius), 0.5);
  return known;
}

// The outline beside a mask, which is drawn by a hand or a threshold to a pixel, where plain edges
// and the outline of a mirror agree on it; else that of the mask.
Circle beside_mask(const Overview& all, const Circle& mask) {
  const Circle edges = refined(all.mean_log, mask, 0.03);
  Circle seen = mirror_outline(all, edges, std::nullopt);
  const double off = (seen.center - edges.center).norm() + std::abs(seen.radius - edges.radius);
  if (edges.coverage < 0.55 || off > 0.3) return mask;  // px
  seen.coverage = mask.coverage;
  return seen;
}

std::vector<Circle> circles_in(const Overview& all, const Extent& extent) {
  std::vector<Circle> circles;
  const auto add = [&](const Grid<float>& picture, const CircleSearch& search) {
    for (const Circle& rough : circle_candidates(picture, search)) {
      const Circle sharp = refined(picture, rough, 0.12);
      if (sharp.coverage < 0.35) continue;
      const bool known = std::any_of(circles.begin(), circles.end(), [&](const Circle& other) {
        return (sharp.center - other.center).norm() + std::abs(sharp.radius - other.radius) <
               0.02 * other.radius + 0.7;
      });
      if (!known) circles.push_back(sharp);
    }
  };
  CircleSearch fine;
  fine.smallest_radius = std::max(6.0, 0.015 * std::min(extent.rows, extent.cols));
  // The outline of a mirror on a dark backdrop may be a step of the file high: it is coherent only
  // once noise and the blocks of a JPEG are averaged.
  CircleSearch coarse = fine;
  coarse.longest_side = 140.0;
  coarse.smallest_radius = 0.05 * std::max(extent.rows, extent.cols);
  for (const CircleSearch& search : {fine, coarse}) {
    add(all.mean_log, search);
    add(all.brightest_log, search);
  }
  return circles;
}

// `views` are the readings of the pictures that are possible: linear, sRGB or either.
Candidate judged(const Photographs& photographs, const std::vector<Overview>& views,
                 const Circle& circle) {
  Candidate candidate;
  candidate.circle = circle;
  double matte = 0.0;
  for (const Overview& view : views) {
    matte = std::max(matte, matte_likeness(photographs, view, circle));
  }
  const double chrome = chrome_likeness(photographs, views.front(), circle);
  constexpr double convincing = 0.65;
  if (matte < convincing && chrome == 0.0) return candidate;
  candidate.kind = matte >= convincing ? SphereKind::matte : SphereKind::chrome;
  candidate.worth = circle.coverage * std::max(matte, 0.8 * chrome);
  if (candidate.kind == SphereKind::matte) {
    // A matte disc is bright on dark: linear values place its edge, logarithms would widen it.
    const Circle sharp = refined(views.front().brightest, circle, 0.08);
    if (sharp.coverage >= 0.8 * circle.coverage) candidate.circle = sharp;
  }
  return candidate;
}

std::string described(const Circle& circle) {
  return fmt::format("circle at ({:.0f}, {:.0f}) px of radius {:.0f} px", circle.center.x(),
                     circle.center.y(), circle.radius);
}

// The convincing candidates that do not overlap, the best first.
std::vector<Candidate> without_overlap(std::vector<Candidate> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.worth > b.worth; });
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (candidate.worth == 0.0) continue;
    const bool overlaps = std::any_of(kept.begin(), kept.end(), [&](const Candidate& other) {
      return (candidate.circle.center - other.circle.center).norm() <
             0.9 * (candidate.circle.radius + other.circle.radius);
    });
    if (!overlaps) kept.push_back(candidate);
  }
  return kept;
}

// A round mask may be the sphere itself, or a round sample beside spheres: it is the sphere where
// nothing outside it behaves like one.
std::vector<Candidate> weighed_against_mask(const std::vector<Candidate>& candidates,
                                            const Candidate& disc) {
  std::vector<Candidate> beside;
  for (const Candidate& candidate : candidates) {
    const double apart = (candidate.circle.center - disc.circle.center).norm();
    const bool outside = apart > 0.9 * (candidate.circle.radius + disc.circle.radius);
    if (outside && candidate.worth > 0.0) beside.push_back(candidate);
  }
  return beside.empty() ? std::vector<Candidate>{disc} : beside;
}

bool in_box(const Circle& circle, const BoxPx& box) {
  const double width = box[2] - box[0];
  const double height = box[3] - box[1];
  // A box is a hint: the circle's middle lies in it and its size is of the box's order.
  return circle.center.x() > box[0] && circle.center.x() < box[2] && circle.center.y() > box[1] &&
         circle.center.y() < box[3] && circle.radius < 0.65 * std::max(width, height) &&
         circle.radius > 0.15 * std::min(width, height);
}

std::string box_text(const BoxPx& box) {
  return fmt::format("[{:.0f}, {:.0f}, {:.0f}, {:.0f}]", box[0], box[1], box[2], box[3]);
}

// The radius of the outline of a sphere at `place` whose diameter somebody has measured.
std::optional<double> known_radius_px(const std::optional<double>& diameter_mm,
                                      const Camera& camera, const Eigen::Vector2d& place_px) {
  if (!diameter_mm || camera.extent.unit != Unit::mm) return std::nullopt;
  SphereInSpace sphere;
  const double radius = 0.5 * *diameter_mm;
  const Eigen::Vector2d place = camera.extent.place(place_px.y() - 0.5, place_px.x() - 0.5);
  sphere.center = {place.x(), place.y(), radius};
  sphere.radius = radius;
  return outline(sphere, camera).radius_px;
}

/// Turns candidates into spheres, and says why where it cannot.
class Selection {
 public:
  Selection(const Photographs& photographs, const Overview& all)
      : photographs_(photographs), all_(all) {}

  bool add(const Candidate& candidate, const CaptureFile::SphereHint& hint) {
    Circle circle = candidate.circle;
    const SphereKind kind = hint.kind.value_or(candidate.kind);
    if (kind == SphereKind::chrome && candidate.given) {
      circle = beside_mask(all_, circle);
    } else if (kind == SphereKind::chrome) {
      const Camera& camera = photographs_.camera;
      circle =
          mirror_outline(all_, circle, known_radius_px(hint.diameter_mm, camera, circle.center));
    }
    if (crosses_frame(circle, photographs_.camera.extent)) {
      found.rejected.push_back(described(circle) +
                               ": a sphere cut off by the frame; move it wholly into the picture");
      return false;
    }
    constexpr double least_coverage = 0.5;
    if (circle.coverage < least_coverage) {
      found.rejected.push_back(
          described(circle) +
          fmt::format(": behaves like a sphere, but only {:.0f} % of an outline is seen",
                      100.0 * circle.coverage));
      return false;
    }
    Sphere sphere = sphere_of(circle, kind);
    sphere.diameter_mm = hint.diameter_mm;
    found.spheres.push_back(sphere);
    return true;
  }

  FoundSpheres found;

 private:
  const Photographs& photographs_;
  const Overview& all_;
};

void add_boxed(Selection& selection, const CaptureFile& file,
               const std::vector<Candidate>& candidates) {
  for (const auto& hint : file.spheres) {
    if (!hint.box) continue;
    std::vector<Candidate> inside;
    for (const Candidate& candidate : candidates) {
      if (in_box(candidate.circle, *hint.box)) inside.push_back(candidate);
    }
    const auto best = without_overlap(inside);
    const std::string where = file.folder.string() + ": sphere box " + box_text(*hint.box);
    if (best.empty()) throw Error(where + " holds no sphere; correct the box or leave it out");
    for (const Sphere& other : selection.found.spheres) {
      if ((other.center_px - best.front().circle.center).norm() < other.radius_px) {
        throw Error(where + " holds the same sphere as another box; leave one of them out");
      }
    }
    if (!selection.add(best.front(), hint)) {
      throw Error(where + ": " + selection.found.rejected.back());
    }
  }
}

}  // namespace

FoundSpheres find_spheres(const Photographs& photographs) {
  std::vector<Overview> views;
  views.push_back(overview(photographs));
  if (!photographs.encoding_known) views.push_back(overview(photographs, !photographs.linear));
  const auto circles = circles_in(views.front(), photographs.camera.extent);
  std::vector<Candidate> candidates(circles.size());
  for_each_index(int(circles.size()), [&](int i) {
    candidates[std::size_t(i)] = judged(photographs, views, circles[std::size_t(i)]);
  });
  if (const auto disc = disc_of(photographs.mask)) {
    Candidate own = judged(photographs, views, *disc);
    own.circle = *disc;
    own.given = true;
    candidates = weighed_against_mask(candidates, own);
  }

  Selection selection(photographs, views.front());
  const auto& hints = photographs.file.spheres;
  if (std::any_of(hints.begin(), hints.end(), [](const auto& h) { return h.box.has_value(); })) {
    add_boxed(selection, photographs.file, candidates);
    return selection.found;
  }
  // Hints without boxes can only be told apart from the left to the right.
  auto best = without_overlap(candidates);
  std::stable_sort(best.begin(), best.end(), [](const Candidate& a, const Candidate& b) {
    return a.circle.center.x() < b.circle.center.x();
  });
  for (std::size_t i = 0; i < best.size(); ++i) {
    selection.add(best[i], hints.size() == best.size() ? hints[i] : CaptureFile::SphereHint{});
  }
  return selection.found;
}

}  // namespace hada
