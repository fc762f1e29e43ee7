#include "fit/end_grain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "fit/absorbance.h"
#include "fit/dark_wood.h"
#include "fit/pith.h"
#include "fit/ring_edges.h"
#include "fit/ring_radii.h"
#include "measure/background.h"
#include "measure/line_field.h"

namespace hada {
namespace {

constexpr double least_seen = 0.25;    // share of its sectors that a ring must be seen in
constexpr int most_rounds = 8;         // of laying flat and fitting
constexpr double rough_rays_px = 3.4;  // distance of rays as long as the shape is not yet known
constexpr double least_gain = 10.0;    // of the information criterion, for more lobes
constexpr double at_rest_px = 0.3;     // by which the pith may still move
constexpr double sharp_px = 0.15;      // scatter that a shape cannot be blamed for
constexpr int highest_level = 4;
constexpr int vessel_rounds = 2;  // of taking vessels away and guessing the pith without them

/// Lobes that a stem of this complexity may have, all flat.
std::vector<GrowthLobe<>> lobes_of(int level, const Unrolled& flat) {
  constexpr int highest[] = {3, 4, 6, 9, 12};   // order
  constexpr int intervals[] = {0, 2, 4, 6, 8};  // of the radius that they may grow in
  std::vector<GrowthLobe<>> lobes = {{2}, {3}};
  const double from = flat.first, to = flat.rho(flat.values.cols() - 1);
  for (int part = 0; part < intervals[level]; ++part) {
    const double low = from + (to - from) * part / intervals[level];
    const double high = from + (to - from) * (part + 1) / intervals[level];
    // Without the whole turn a lobe of order 1 is a shift of the pith, which is there already.
    for (int order = flat.whole_turn ? 1 : 2; order <= highest[level]; ++order)
      lobes.push_back({double(order), 0.0, 0.0, low, high});
  }
  return lobes;
}

GrowthFrame rough_frame(const PithGuess& guess) {
  GrowthFrame frame;
  frame.pith = guess.place;
  frame.lobes = {{2, guess.oval_cosine, guess.oval_sine}, {3}};
  return frame;
}

/// The mask without vessels and their blurred rims.
Mask without_discs(Mask mask, const std::vector<Disc>& discs) {
  constexpr double rim_px = 2.0;
  for (const Disc& disc : discs)
    for_pixels_in(disc, rim_px, mask, [&](int row, int col) { mask(row, col) = 0; });
  return mask;
}

/// What is laid flat and refined together.
class Refinement {
 public:
  Refinement(const Grid<float>& map, const Mask& mask, const Extent& extent, const PithGuess& guess)
      : map_(map), mask_(mask), extent_(extent), frame_(rough_frame(guess)) {}

  /// Fits pieces of rings, of which nobody says which belong together, until the pith is at rest.
  void follow_pieces() {
    bool rejected = false;  // more lobes, which are not tried again before the pith is at rest
    for (int round = 0; round < most_rounds; ++round) {
      lay_flat(rough_rays_px);
      const auto chains = ring_chains(edges_, flat_, extent_.pitch);
      if (chains.empty()) {
        throw Error("wood: no rings can be followed; give a sharper or larger picture of the end");
      }
      const auto points = points_on(chains);
      const int count = int(chains.size());
      shape_ = fitted_shape(points, count, frame_, Scatter::relative);
      const bool at_rest =
          round > 0 && (shape_.frame.pith - frame_.pith).norm() < at_rest_px * extent_.pitch;
      bool richer = false;
      // What was laid flat by a guess scatters by the guess's errors.
      if (round > 0 && level_ < highest_level && shape_.scatter > sharp_px * extent_.pitch &&
          (at_rest || !rejected)) {
        GrowthFrame frame = shape_.frame;
        frame.lobes = lobes_of(level_ + 1, flat_);
        auto better = fitted_shape(points, count, frame, Scatter::relative);
        richer = gain_of(better, shape_) > least_gain;
        rejected = !richer;
        if (richer) {
          shape_ = std::move(better);
          ++level_;
        }
      }
      frame_ = shape_.frame;
      if (at_rest && !richer) return;
    }
  }

  /// Fits whole rings, one radius each.
  void settle_rings() {
    constexpr double reach_px = 2.5, reach_scatters = 4.0;
    lay_flat(UnrollOptions{}.ray_px);
    const double reach = std::max(reach_scatters * shape_.scatter, reach_px * extent_.pitch);
    auto rings =
        edges_of_rings(ring_radii(flat_, extent_.pitch), edges_, flat_, reach, extent_.pitch);
    std::erase_if(rings, [](const RingChain& ring) { return ring.empty(); });
    const auto chains = ring_chains(edges_, flat_, extent_.pitch);
    for (RingChain& ring : wandering_rings(rings, chains, flat_, reach, extent_.pitch))
      rings.push_back(std::move(ring));
    std::stable_sort(rings.begin(), rings.end(), [](const RingChain& a, const RingChain& b) {
      return radius_of(a) < radius_of(b);
    });
    std::erase_if(rings,
                  [&](const RingChain& ring) { return !stands_out(ring, flat_, extent_.pitch); });
    seen_share_.clear();
    std::erase_if(rings, [&](const RingChain& ring) {
      const double share = double(ring.size()) / std::max(1, sectors_at(flat_, ring.front().rho));
      if (share >= least_seen) seen_share_.push_back(std::min(share, 1.0));
      return share < least_seen;
    });
    if (rings.size() < 2) {
      throw Error("wood: fewer than two rings can be seen; give a larger picture of the end grain");
    }
    shape_ = fitted_shape(points_on(rings), int(rings.size()), frame_,
                          level_ == 0 ? Scatter::even : Scatter::relative);
    frame_ = shape_.frame;
    rise_ = ring_rise(rings, shape_.radii, flat_);
  }

  const RingShape& shape() const { return shape_; }
  const RingRise& rise() const { return rise_; }
  const std::vector<double>& seen_share() const { return seen_share_; }
  int level() const { return level_; }

 private:
  void lay_flat(double ray_px) {
    flat_ = unrolled(map_, mask_, extent_, frame_, {.ray_px = ray_px});
    edges_ = ring_edges(flat_, extent_.pitch);
  }

  std::vector<RingPoint> points_on(const std::vector<RingChain>& chains) const {
    std::vector<GrowthRay> rays;
    for (const double theta : flat_.theta) rays.emplace_back(frame_.lobes, theta);
    std::vector<RingPoint> points;
    for (std::size_t ring = 0; ring < chains.size(); ++ring) {
      for (const RingEdge& edge : chains[ring]) {
        const double theta = flat_.theta[std::size_t(edge.sector)];
        const double radius = rays[std::size_t(edge.sector)].radius_at(edge.rho);
        points.push_back(
            {frame_.pith + radius * Eigen::Vector2d(std::cos(theta), std::sin(theta)), int(ring)});
      }
    }
    return points;
  }

  const Grid<float>& map_;
  const Mask& mask_;
  Extent extent_;
  GrowthFrame frame_;
  Unrolled flat_;
  std::vector<std::vector<RingEdge>> edges_;
  RingShape shape_;
  RingRise rise_;
  std::vector<double> seen_share_;
  int level_ = 0;
};

}  // namespace

EndGrain end_grain(const Surface& surface) {
  if (surface.albedo.empty()) {
    throw Error("wood: the surface has no albedo; give a picture of an end grain");
  }
  const Extent& extent = surface.extent;
  EndGrain grain;
  const auto brightness = luminance(surface.albedo);
  const int margin = std::max(2, std::min(extent.rows, extent.cols) / 200);
  grain.wood = without_background(brightness, surface.mask, margin);
  const auto map = absorbance(brightness);
  const auto directions_in = [&](const Mask& mask) {
    return ring_directions(line_field(map, mask), extent);
  };
  auto guess = pith_guess(directions_in(grain.wood), extent);
  Mask clear = grain.wood;
  for (int round = 0; round < vessel_rounds; ++round) {
    const auto seen = dark_wood(brightness, grain.wood, rough_frame(guess), extent);
    if (!seen) break;
    Mask between = without_discs(grain.wood, seen->discs);
    const auto directions = directions_in(between);
    if (directions.size() < fewest_directions) break;  // vessels leave too little to see rings in
    clear = std::move(between);
    guess = pith_guess(directions, extent);
  }
  Refinement refinement(map, clear, extent, guess);
  refinement.follow_pieces();
  refinement.settle_rings();
  refinement.settle_rings();
  grain.shape = refinement.shape();
  grain.rise = refinement.rise();
  grain.level = refinement.level();
  grain.seen_share = refinement.seen_share();
  const Eigen::Vector2d pith_px = extent.pixel(grain.shape.frame.pith);
  grain.pith_inside =
      grain.wood.contains(int(std::lround(pith_px.x())), int(std::lround(pith_px.y())));
  return grain;
}

}  // namespace hada
