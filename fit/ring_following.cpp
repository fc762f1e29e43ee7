#include "fit/ring_following.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fit/faces_left_out.h"
#include "fit/further_rings.h"
#include "fit/ring_threads.h"
#include "fit/ripple_prior.h"

namespace hada {
namespace {

constexpr double least_noise_px = 0.05;
constexpr int most_rounds = 14;
constexpr double first_noise_px = 0.5;
constexpr double least_growth = 1.02;  // of the number of sightings, to look once more
constexpr double most_lost = 0.8;      // of the sightings, from round to round
constexpr double sharp_px = 0.3;       // scatter that no ripple can be blamed for
constexpr double first_length = 0.12;  // of ripples, beside the longest side of the block
constexpr double least_gain = 10.0;    // of the logarithm of the evidence, for ripples
constexpr double together = 9.0;       // neighbours whose sightings share most of their pixels
constexpr double most_out = 0.7;       // sine to a face of the growth of a ring that it shows
constexpr int most_extensions = 4;     // by rings that the end grain does not show
constexpr int waves = 300;
constexpr std::size_t fewest = 20;

/// The box around all faces, a little larger: waves are flat at its sides.
Ripples::Box box_of(const std::vector<BlockFace>& faces) {
  constexpr double wider = 0.15;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
  for (const BlockFace& face : faces) {
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const StemVector corner = face.cut.at(x * face.extent.width(), y * face.extent.height());
        const Eigen::Vector3d place(corner[0], corner[1], corner[2]);
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
      }
    }
  }
  const Eigen::Vector3d margin = wider * (high - low).maxCoeff() * Eigen::Vector3d::Ones();
  const Eigen::Vector3d least = low - margin, sides = high - low + 2.0 * margin;
  return {{least.x(), least.y(), least.z()}, {sides.x(), sides.y(), sides.z()}};
}

/// What is known at one time, and what it was learnt from.
struct State {
  GrowthSolid start, solid;
  SolidPrior prior;
  std::vector<RingSighting> seen;
  std::vector<FaceScatter> faces;
};

/// Predict, look, learn: the solid and what it has led to.
class Following {
 public:
  Following(const std::vector<BlockFace>& faces, const GrowthSolid& start, const SolidPrior& prior,
            RingMark mark, double scatter)
      : views_(faces), box_(box_of(faces)), pitch_(faces.front().extent.pitch), mark_(mark) {
    now_.start = now_.solid = start;
    now_.prior = prior;
    noise_.assign(faces.size(), std::max(scatter, first_noise_px * pitch_));
    if (mark != RingMark::line) return;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const auto some = ring_threads(faces[k], k, usual_width(start) / pitch_);
      threads_.insert(threads_.end(), some.begin(), some.end());
    }
  }

  Followed run() {
    settle_down();
    for (int round = 0; mark_ == RingMark::line && round < most_extensions; ++round) {
      if (!extend()) break;
      settle_down();
    }
    if (!now_.prior.ripples.empty()) {
      const double by = surprise_of_faces(now_.seen, clear_threads(), now_.start, now_.prior,
                                          now_.faces, least_noise_px * pitch_);
      for (double& sigma : now_.prior.ripples) sigma *= by;
      take(fitted(now_.seen));
    }
    return {now_.solid, now_.faces};
  }

 private:
  /// Looks and learns until nothing new is seen.
  void settle_down() {
    State kept;
    for (int round = 0; round < most_rounds; ++round) {
      look();
      if (now_.seen.size() < fewest) {
        throw Error("wood: too few rings can be followed over the faces; check their planes");
      }
      learn();
      const double before = double(kept.seen.size()), after = double(now_.seen.size());
      if (after < most_lost * before) break;  // it went astray: the last stays
      kept = now_;
      if (round > 1 && after < least_growth * before) break;
    }
    now_ = std::move(kept);
  }

  void look() {
    now_.seen.clear();
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const auto some = ring_sightings(views_[k], k, now_.solid, mark_, noise_[k]);
      now_.seen.insert(now_.seen.end(), some.begin(), some.end());
    }
  }

  SolidFit fitted(const std::vector<RingSighting>& seen) const {
    return fitted_solid(seen, now_.start, now_.prior, views_.size(), least_noise_px * pitch_,
                        clear_threads());
  }

  void take(const SolidFit& fit) {
    now_.solid = fit.solid;
    now_.faces = fit.faces;
  }

  /// Those on faces that rings cross steeply: elsewhere fibres are what runs on.
  std::vector<RingThread> clear_threads() const {
    std::vector<RingThread> clear;
    for (const RingThread& thread : threads_) {
      const Eigen::Vector3d gradient = local_of(now_.solid, thread.from, false).gradient;
      const StemVector eye = views_[thread.face].cut.towards_eye();
      const double out = gradient.dot(Eigen::Map<const Eigen::Vector3d>(eye.data()));
      if (std::abs(out) < most_out * gradient.norm()) clear.push_back(thread);
    }
    return clear;
  }

  /// Learns from what is seen; ripples where the rest is more than noise, and only as they pay.
  void learn() {
    now_.start.ripples = {};
    now_.prior.ripples.clear();
    now_.prior.together = 1.0;
    SolidFit fit = fitted(now_.seen);
    double scatter = 0.0;
    for (const auto& face : fit.faces) scatter = std::max(scatter, face.scatter);
    if (scatter > sharp_px * pitch_) {
      const State plain = now_;
      now_.start.ripples = ripples_in(box_, waves);
      now_.prior.together = together;
      const double length = first_length * *std::max_element(box_.sides.begin(), box_.sides.end());
      const RipplePrior plainest{2.0 * scatter, length, length};
      if (ripple_.height <= 0.0) ripple_ = plainest;
      SolidFit rippled;
      for (int round = 0; round < 2; ++round) {
        now_.prior.ripples = wave_sigma(now_.start.ripples, ripple_);
        rippled = fitted(now_.seen);
        ripple_ = likely_ripples(rippled.solid, rippled.equations, {ripple_, plainest});
      }
      if (ripple_.gain < least_gain) {
        now_ = plain;
      } else {
        fit = std::move(rippled);
      }
    }
    take(fit);
    for (std::size_t k = 0; k < noise_.size(); ++k) {
      if (fit.faces[k].sightings > 0) noise_[k] = fit.faces[k].scatter;
    }
  }

  /// Takes up rings that the faces show beside those that are known; whether there are any.
  bool extend() {
    const auto found = further_rings(views_, now_.solid);
    if (found.empty()) return false;
    const auto before = now_.start.radii;
    auto& radii = now_.start.radii;
    radii.insert(radii.end(), found.begin(), found.end());
    std::sort(radii.begin(), radii.end());
    for (RingSighting& one : now_.seen)
      one.ring = std::size_t(std::lower_bound(radii.begin(), radii.end(), before[one.ring]) -
                             radii.begin());
    take(fitted(now_.seen));
    return true;
  }

  const std::vector<BlockFace>& views_;
  std::vector<RingThread> threads_;
  Ripples::Box box_;
  double pitch_;
  RingMark mark_;
  State now_;
  std::vector<double> noise_;  // of each face
  RipplePrior ripple_;
};

}  // namespace

Followed followed_rings(const std::vector<BlockFace>& faces, const GrowthSolid& start,
                        const SolidPrior& prior, RingMark mark, double scatter) {
  return Following(faces, start, prior, mark, scatter).run();
}

}  // namespace hada
