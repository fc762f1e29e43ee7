#include "fit/block.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/quantile.h"
#include "fit/absorbance.h"
#include "fit/block_fibres.h"
#include "fit/ring_following.h"
#include "fit/wood.h"
#include "measure/background.h"

namespace hada {
namespace {

constexpr double across_stem = 0.98;  // cosine to the stem of the normal of an end grain
constexpr double vague_pith =
    0.1;  // of its distance, standard deviation of a pith that is not known
constexpr double steep_prior = 0.08;  // lean of a stem that rings run side by side in
constexpr double pith_share = 0.5;    // of its distance that a pith may be off
constexpr double boundary_px = 0.35;  // within a rise, where others may draw the end of a ring
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

/// How far rings lie beside those of the solid, on a usual face: what no solid says of another one.
double wander_of(const std::vector<FaceScatter>& faces) {
  std::vector<double> scatters;
  for (const FaceScatter& face : faces) {
    if (face.sightings >= int(fewest)) scatters.push_back(face.scatter);
  }
  return scatters.empty() ? 0.0 : median(std::move(scatters));
}

/// Lets rings begin where their rise does; where that is not known, others may draw them anywhere
/// within it.
void begin_rings(GrowthSolid& solid, const RingRise& rise, double wander, double pitch) {
  const RingOnset onset = onset_of(rise, solid.radii);
  for (std::size_t k = 0; k < solid.radii.size(); ++k) {
    solid.radii[k] -= onset.before[k];
    const double boundary = rise.share > 0.0 ? onset.sigma[k] : boundary_px * pitch;
    solid.radii_loose.push_back(std::hypot(boundary, wander));
  }
}

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
  fit.sigma.ring_radii_mm.resize(solid.radii.size());
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
  std::vector<BlockFace> views;
  for (const PlacedFace& face : faces) views.push_back(block_face(face));
  const Followed followed = followed_rings(views, start, prior, block.mark, grain.shape.scatter);
  block.solid = followed.solid;
  block.faces = followed.faces;
  block.solid.radii_loose.clear();
  // A dark line of pores has no rise.
  const RingRise rise = block.mark == RingMark::line ? RingRise{} : grain.rise;
  begin_rings(block.solid, rise, wander_of(block.faces), pitch);
  set_solid(block.wood, block.solid);
  add_turning(block.wood, block.solid, faces);
  return block;
}

}  // namespace hada
