#include "fit/block.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/quantile.h"
#include "fit/absorbance.h"
#include "fit/block_fibres.h"
#include "fit/ripple_prior.h"
#include "fit/wood.h"
#include "measure/background.h"

namespace hada {
namespace {

constexpr double across_stem = 0.98;  // cosine to the stem of the normal of an end grain
constexpr double least_noise_px = 0.05;
constexpr int most_rounds = 14;
constexpr double first_noise_px = 0.5;
constexpr double least_growth = 1.005;  // of the number of sightings, to look once more
constexpr double most_lost = 0.8;       // of the sightings, from round to round
constexpr double sharp_px = 0.3;        // scatter that no ripple can be blamed for
constexpr double first_length = 0.12;   // of ripples, beside the longest side of the block
constexpr double least_gain = 10.0;     // of the logarithm of the evidence, for ripples
constexpr double together = 9.0;        // neighbours whose sightings share most of their pixels
constexpr double vague_pith =
    0.1;  // of its distance, standard deviation of a pith that is not known
constexpr double steep_prior = 0.08;  // lean of a stem that rings run side by side in
constexpr double pith_share = 0.5;    // of its distance that a pith may be off
constexpr int waves = 300;
constexpr std::size_t fewest = 20;

bool is_end_grain(const PlacedFace& face) {
  return std::abs(face.cut.towards_eye()[2]) > across_stem;
}

/// What pith and lobes are in the frame of the stem that are those of a picture of its end grain.
GrowthFrame in_stem(const Wood<>& seen, const Cut& cut) {
  GrowthFrame frame;
  const StemVector pith = cut.at(seen.pith_mm[0], seen.pith_mm[1]);
  frame.pith = {pith[0], pith[1]};
  const double turned = std::atan2(cut.right[1], cut.right[0]);
  const double mirrored = cut.towards_eye()[2] > 0.0 ? 1.0 : -1.0;
  frame.lobes = seen.lobes;
  for (auto& lobe : frame.lobes) {
    const double c = std::cos(lobe.order * turned), s = std::sin(lobe.order * turned);
    const double cosine = lobe.cosine, sine = mirrored * lobe.sine;
    lobe.cosine = cosine * c - sine * s;
    lobe.sine = cosine * s + sine * c;
  }
  return frame;
}

/// What an end grain alone says, and how little that is of other heights.
GrowthSolid first_solid(const Fit<Wood<>>& seen, const Cut& cut, const SolidPrior& prior,
                        double pitch) {
  GrowthSolid solid;
  solid.frame = in_stem(seen.material, cut);
  solid.radii = seen.material.ring_radii_mm;
  Eigen::VectorXd sigma = Eigen::VectorXd::Zero(solid.size());
  sigma.segment<2>(2).setConstant(prior.lean);
  sigma[4] = prior.taper;
  for (std::size_t k = 0; k < solid.radii.size(); ++k)
    sigma[solid.radii_at() + Eigen::Index(k)] = 0.5 * pitch;
  // The end grain is where all is known: pith and effective radius are those of its height.
  const double z = cut.origin[2];
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(solid.size(), solid.size());
  turn(0, 2) = turn(1, 3) = -z;
  for (std::size_t k = 0; k < solid.radii.size(); ++k)
    turn(solid.radii_at() + Eigen::Index(k), 4) = z;
  solid.covariance = turn * sigma.cwiseAbs2().asDiagonal() * turn.transpose();
  return solid;
}

/// The box around all faces, a little larger: waves are flat at its sides.
Ripples::Box box_of(const std::vector<PlacedFace>& faces) {
  constexpr double wider = 0.15;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
  for (const PlacedFace& face : faces) {
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const StemVector corner =
            face.cut.at(x * face.surface.extent.width(), y * face.surface.extent.height());
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

std::vector<RingSighting> seen_on(const std::vector<BlockFace>& faces, const GrowthSolid& solid,
                                  RingMark mark, const std::vector<double>& noise) {
  std::vector<RingSighting> all;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto some = ring_sightings(faces[k], k, solid, mark, noise[k]);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// How far rings lie beside those of the solid, on a usual face: what no solid says of another one.
double wander_of(const std::vector<FaceScatter>& faces) {
  std::vector<double> scatters;
  for (const FaceScatter& face : faces) {
    if (face.sightings >= int(fewest)) scatters.push_back(face.scatter);
  }
  return scatters.empty() ? 0.0 : median(std::move(scatters));
}

/// Predict, look, learn: the solid and what it has led to.
class Following {
 public:
  Following(const std::vector<PlacedFace>& faces, const GrowthSolid& start, const SolidPrior& prior,
            double pitch, double noise)
      : box_(box_of(faces)), start_(start), prior_(prior), pitch_(pitch), solid_(start) {
    for (const PlacedFace& face : faces) views_.push_back(block_face(face));
    noise_.assign(faces.size(), std::max(noise, first_noise_px * pitch));
  }

  void follow(RingMark mark) {
    std::size_t before = 0;
    for (int round = 0; round < most_rounds; ++round) {
      const auto seen = seen_on(views_, solid_, mark, noise_);
      if (seen.size() < fewest) {
        throw Error("wood: too few rings can be followed over the faces; check their planes");
      }
      settle(seen);
      if (double(seen.size()) < most_lost * double(before))
        break;  // it went astray: the last stays
      kept_ = {solid_, scatter_};
      if (round > 1 && double(seen.size()) < least_growth * double(before)) break;
      before = seen.size();
    }
  }

  const GrowthSolid& solid() const { return kept_.first; }
  const std::vector<FaceScatter>& faces() const { return kept_.second; }

 private:
  SolidFit fitted(const std::vector<RingSighting>& seen) const {
    return fitted_solid(seen, start_, prior_, views_.size(), least_noise_px * pitch_);
  }

  /// Learns from what is seen; ripples where the rest is more than noise, and only as they pay.
  void settle(const std::vector<RingSighting>& seen) {
    start_.ripples = {};
    prior_.ripples.clear();
    prior_.together = 1.0;
    SolidFit fit = fitted(seen);
    double scatter = 0.0;
    for (const auto& face : fit.faces) scatter = std::max(scatter, face.scatter);
    if (scatter > sharp_px * pitch_) {
      SolidFit plain = std::move(fit);
      start_.ripples = ripples_in(box_, waves);
      prior_.together = together;
      const double length = first_length * *std::max_element(box_.sides.begin(), box_.sides.end());
      const RipplePrior plainest{2.0 * scatter, length, length};
      if (ripple_.height <= 0.0) ripple_ = plainest;
      for (int round = 0; round < 2; ++round) {
        prior_.ripples = wave_sigma(start_.ripples, ripple_);
        fit = fitted(seen);
        ripple_ = likely_ripples(fit.solid, fit.equations, {ripple_, plainest});
      }
      if (ripple_.gain < least_gain) fit = std::move(plain);
    }
    solid_ = fit.solid;
    scatter_ = fit.faces;
    for (std::size_t k = 0; k < noise_.size(); ++k) {
      if (fit.faces[k].sightings > 0) noise_[k] = fit.faces[k].scatter;
    }
  }

  std::vector<BlockFace> views_;
  Ripples::Box box_;
  GrowthSolid start_;
  SolidPrior prior_;
  double pitch_;
  GrowthSolid solid_;
  std::vector<double> noise_;  // of each face
  std::vector<FaceScatter> scatter_;
  RipplePrior ripple_;
  std::pair<GrowthSolid, std::vector<FaceScatter>> kept_;  // the last that led on
};

/// What a material can say of `solid`; ripples are left out.
void set_solid(Fit<Wood<>>& fit, const GrowthSolid& solid) {
  const Eigen::VectorXd sigma = solid.covariance.diagonal().cwiseSqrt();
  const auto pair = [](const Eigen::Vector2d& v) { return std::vector<double>{v.x(), v.y()}; };
  fit.material.pith_mm = pair(solid.frame.pith);
  fit.sigma.pith_mm = pair(sigma.head<2>());
  fit.material.pith_lean = pair(solid.lean);
  fit.sigma.pith_lean = pair(sigma.segment<2>(2));
  fit.material.taper = solid.taper;
  fit.sigma.taper = sigma[4];
  fit.material.lobes = solid.frame.lobes;
  fit.sigma.lobes.clear();
  for (std::size_t l = 0; l < solid.frame.lobes.size(); ++l) {
    const Eigen::Index at = solid.lobes_at() + 2 * Eigen::Index(l);
    fit.sigma.lobes.push_back({0.0, sigma[at], sigma[at + 1], 0.0, 0.0});
  }
  fit.material.ring_radii_mm = solid.radii;
  for (std::size_t k = 0; k < solid.radii.size(); ++k)
    fit.sigma.ring_radii_mm[k] =
        std::hypot(sigma[solid.radii_at() + Eigen::Index(k)], solid.radii_loose[k]);
}

}  // namespace

BlockFace block_face(const PlacedFace& face) {
  const Extent& extent = face.surface.extent;
  const auto brightness = luminance(face.surface.albedo);
  const int margin = std::max(2, std::min(extent.rows, extent.cols) / 200);
  return {absorbance(brightness), without_background(brightness, face.surface.mask, margin), extent,
          face.cut};
}

BlockFit fit_block(const std::vector<PlacedFace>& faces) {
  const auto anchor = std::find_if(faces.begin(), faces.end(), is_end_grain);
  if (anchor == faces.end()) {
    throw Error(
        "wood: none of the faces is an end grain; give one that is cut across the stem, which is "
        "z");
  }
  const EndGrain grain = end_grain(anchor->surface);
  BlockFit block;
  block.wood = wood_of(grain, anchor->surface);
  const double pitch = anchor->surface.extent.pitch;
  const Eigen::Vector2d pith(block.wood.material.pith_mm[0], block.wood.material.pith_mm[1]);
  SolidPrior prior{.pith = pith_share * pith.norm() + 10.0 * pitch, .ripples = {}};
  GrowthSolid start = first_solid(block.wood, anchor->cut, prior, pitch);
  if (grain.shape.pith_sigma.norm() > vague_pith * pith.norm()) {
    // Rings run side by side: nothing says how they are shaped around a pith, or how it leans.
    block.wood.material.lobes.clear();
    block.wood.sigma.lobes.clear();
    prior.lean = steep_prior;
    start = first_solid(block.wood, anchor->cut, prior, pitch);
    start.lean = fibre_lean(faces);
    start.frame.pith -= start.lean * anchor->cut.origin[2];
    block.mark = RingMark::line;
  }
  Following following(faces, start, prior, pitch, grain.shape.scatter);
  following.follow(block.mark);
  block.solid = following.solid();
  block.faces = following.faces();
  block.solid.radii_loose.assign(block.solid.radii.size(),
                                 std::hypot(boundary_px * pitch, wander_of(block.faces)));
  set_solid(block.wood, block.solid);
  add_turning(block.wood, block.solid, faces);
  return block;
}

}  // namespace hada
