#include "measure/hills.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hada {
namespace {

using Index = std::uint32_t;  // of a pixel, or of a hill

constexpr float outside = -std::numeric_limits<float>::infinity();

/// A map with a border all around, outside the mask as deep as can be.
class Ground {
 public:
  Ground(const Grid<float>& height, const Mask& mask)
      : height_(height.rows() + 2, height.cols() + 2, outside) {
    for (int row = 0; row < height.rows(); ++row) {
      for (int col = 0; col < height.cols(); ++col) {
        if (mask(row, col)) height_(row + 1, col + 1) = height(row, col);
      }
    }
  }
  Index size() const { return Index(height_.size()); }
  float operator[](Index pixel) const { return height_[pixel]; }
  bool counts(Index pixel) const { return height_[pixel] != outside; }
  /// Whether one pixel emerges from a falling flood before the other.
  bool before(Index a, Index b) const {
    return height_[a] > height_[b] || (height_[a] == height_[b] && a < b);
  }
  /// Calls visit(neighbour) for the eight around a pixel that counts.
  template <class Visit>
  void visit_neighbours(Index pixel, const Visit& visit) const {
    const Index cols = Index(height_.cols());
    for (const Index middle : {pixel - cols, pixel, pixel + cols}) {
      visit(middle - 1);
      if (middle != pixel) visit(middle);
      visit(middle + 1);
    }
  }

 private:
  Grid<float> height_;
};

/// Shortens links to where they lead at last.
void shorten(std::vector<Index>& links) {
  for (Index i = 0; i < links.size(); ++i) {
    Index end = i;
    while (links[end] != end) end = links[end];
    for (Index at = i; at != end;) at = std::exchange(links[at], end);
  }
}

/// A map divided among its hills.
struct Hills {
  std::vector<Index> summits;   // pixel
  std::vector<Index> of_pixel;  // hill
};

// Each pixel belongs to the summit that steps to the highest neighbour lead to.
Hills single_hills(const Ground& ground) {
  Hills hills{{}, std::vector<Index>(ground.size())};
  std::vector<Index>& links = hills.of_pixel;
  for (Index pixel = 0; pixel < ground.size(); ++pixel) {
    Index highest = pixel;
    if (ground.counts(pixel)) {
      ground.visit_neighbours(pixel, [&](Index neighbour) {
        if (ground.before(neighbour, highest)) highest = neighbour;
      });
    }
    links[pixel] = highest;
  }
  shorten(links);
  std::vector<Index> number(ground.size());
  for (Index pixel = 0; pixel < links.size(); ++pixel) {
    if (!ground.counts(pixel) || links[pixel] != pixel) continue;
    number[pixel] = Index(hills.summits.size());
    hills.summits.push_back(pixel);
  }
  for (Index& link : links) link = number[link];
  return hills;
}

// Calls visit(other hill) for the neighbours that emerged before this pixel.
template <class Visit>
void visit_passes(const Hills& hills, const Ground& ground, Index pixel, const Visit& visit) {
  const Index here = hills.of_pixel[pixel];
  ground.visit_neighbours(pixel, [&](Index neighbour) {
    const Index there = hills.of_pixel[neighbour];
    if (there != here && ground.before(neighbour, pixel)) visit(there);
  });
}

/// The highest way out of a hill.
struct Pass {
  Index pixel = 0;
  Index beyond = 0;  // which hill; the same one where there is no way
};

// Of several hills at one pixel the way leads to the highest. Borders that are none any longer are
// left out from then on.
std::vector<Pass> highest_passes(const Hills& hills, const Ground& ground,
                                 std::vector<Index>& borders) {
  std::vector<Pass> passes(hills.summits.size());
  for (Index hill = 0; hill < passes.size(); ++hill) passes[hill].beyond = hill;
  const auto offer = [&](Index hill, Index pixel, Index beyond) {
    Pass& pass = passes[hill];
    if (pass.beyond == hill || ground.before(pixel, pass.pixel) ||
        (pixel == pass.pixel && ground.before(hills.summits[beyond], hills.summits[pass.beyond])))
      pass = {pixel, beyond};
  };
  std::erase_if(borders, [&](Index pixel) {
    bool is_border = false;
    visit_passes(hills, ground, pixel, [&](Index there) {
      is_border = true;
      offer(hills.of_pixel[pixel], pixel, there);
      offer(there, pixel, hills.of_pixel[pixel]);
    });
    return !is_border;
  });
  return passes;
}

}  // namespace

int hill_count(const Grid<float>& height, const Mask& mask, double least_rise) {
  const Ground ground(height, mask);
  Hills hills = single_hills(ground);
  std::vector<Index> borders;  // pixels that passes may lead through
  borders.reserve(ground.size());
  for (Index pixel = 0; pixel < ground.size(); ++pixel) {
    if (ground.counts(pixel)) borders.push_back(pixel);
  }
  int count = int(hills.summits.size());
  // A hill ends at its highest pass if that leads to a higher one, in whichever order they join.
  for (bool joined = true; joined;) {
    joined = false;
    const auto passes = highest_passes(hills, ground, borders);
    std::vector<Index> links(hills.summits.size());
    for (Index hill = 0; hill < links.size(); ++hill) {
      const auto [pass, beyond] = passes[hill];
      const Index summit = hills.summits[hill];
      links[hill] = ground.before(hills.summits[beyond], summit) ? beyond : hill;
      if (links[hill] == hill) continue;
      joined = true;
      if (ground[summit] - ground[pass] < least_rise) --count;
    }
    shorten(links);
    for (Index& hill : hills.of_pixel) hill = links[hill];
  }
  return count;
}

}  // namespace hada
