#include "synth/forged.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/srgb.h"
#include "synth/white_noise.h"

namespace hada {
namespace {

constexpr std::size_t longest_sequence = 16;
constexpr int lanes = 16;  // columns that are hammered together: a cache line
constexpr float third = 1.0f / 3.0f;

int count_of(const std::string& sequence, char cut) {
  return int(std::count(sequence.begin(), sequence.end(), cut));
}

/// How many layers the first cut along this axis makes: 2, or 1 if there is none.
int halves(const std::string& sequence, char cut) {
  return count_of(sequence, cut) > 0 ? 2 : 1;
}

int rounded_up(int size, int unit) {
  return (size + unit - 1) / unit * unit;
}

/// What lies beyond the far end of a line; beyond its near end, the rim of the field, lies nothing.
enum class FarEnd { rim, next_fold };

/// Hammering of `width` neighbouring lines, whose places lie interleaved as in the rows of a grid.
///
/// A line is kept with its next cut already made and laid over: beyond its far end, which is that
/// cut, lies its own mirror image, and the moving average does not change under the fold.
template <int width>
class Line {
 public:
  Line(const float* places, int count, FarEnd far, int most)
      : now_(std::size_t(most) * width), next_(now_), count_(count), far_(far) {
    std::copy(places, places + std::size_t(count) * width, now_.begin());
  }

  /// Every place twice, then the mean of three; the next cut is made if one is still to come.
  void stretch(bool cuts_remain) {
    const int n = count_;
    const float* g = now_.data();
    float* h = next_.data();
    for (int w = 0; w < width; ++w) h[w] = 2.0f * third * g[w];
    for (int m = 0; m + 1 < n; ++m) {
      const float* here = g + std::size_t(m) * width;
      float* odd = h + std::size_t(2 * m + 1) * width;
      for (int w = 0; w < width; ++w) {
        const float a = third * here[w], b = third * here[w + width];
        odd[w] = a + a + b;
        odd[w + width] = a + b + b;
      }
    }
    const float* last = g + std::size_t(n - 1) * width;
    float* end = h + std::size_t(2 * n - 1) * width;
    for (int w = 0; w < width; ++w) end[w] = 2.0f * third * last[w];
    now_.swap(next_);
    count_ = 2 * n;
    far_ = FarEnd::rim;
    if (cuts_remain) fold();
  }

  /// The mean of three.
  void smooth() {
    const std::size_t size = std::size_t(count_) * width, last = size - width;
    const float* g = now_.data();
    float* h = next_.data();
    for (std::size_t k = width; k < last; ++k) h[k] = third * (g[k - width] + g[k] + g[k + width]);
    for (std::size_t w = 0; w < width; ++w) {
      const float beyond = far_ == FarEnd::next_fold ? g[last + w] : 0.0f;
      if (count_ == 1) {
        h[w] = third * (g[w] + beyond);
      } else {
        h[w] = third * (g[w] + g[w + width]);
        h[last + w] = third * (g[last + w - width] + g[last + w] + beyond);
      }
    }
    now_.swap(next_);
  }

  const float* places() const { return now_.data(); }

 private:
  void fold() {
    count_ /= 2;
    far_ = FarEnd::next_fold;
    float* g = now_.data();
    const float* over = g + std::size_t(2 * count_ - 1) * width;
    for (int m = 0; m < count_; ++m) {
      float* here = g + std::size_t(m) * width;
      const float* there = over - std::size_t(m) * width;
      for (int w = 0; w < width; ++w) here[w] = 0.5f * (here[w] + there[w]);
    }
  }

  std::vector<float> now_;
  std::vector<float> next_;
  int count_;
  FarEnd far_;
};

/// All folds as the lines along the direction that `cut` stretches see them.
template <int width>
void hammer(Line<width>& line, const std::string& sequence, char cut, HammerKernel kernel) {
  int remaining = count_of(sequence, cut);
  for (const char fold : sequence) {
    if (fold == cut) {
      line.stretch(--remaining > 0);
    } else if (kernel == HammerKernel::both) {
      line.smooth();
    }
  }
}

FarEnd far_end(const std::string& sequence, char cut) {
  return count_of(sequence, cut) > 0 ? FarEnd::next_fold : FarEnd::rim;
}

void hammer_columns(const Grid<float>& pile, Grid<float>& out, const std::string& sequence,
                    HammerKernel kernel) {
  const int cols = pile.cols();
  for_slices((cols + lanes - 1) / lanes, [&](int begin, int end) {
    std::vector<float> bundle(std::size_t(pile.rows()) * lanes);
    for (int block = begin; block < end; ++block) {
      const int first = block * lanes, count = std::min(lanes, cols - first);
      for (int row = 0; row < pile.rows(); ++row)
        std::copy_n(&pile(row, first), count, bundle.data() + std::size_t(row) * lanes);
      Line<lanes> lines(bundle.data(), pile.rows(), far_end(sequence, 'R'), out.rows());
      hammer(lines, sequence, 'R', kernel);
      for (int row = 0; row < out.rows(); ++row)
        std::copy_n(lines.places() + std::size_t(row) * lanes, count, &out(row, first));
    }
  });
}

void hammer_rows(const Grid<float>& tall, Grid<float>& out, const std::string& sequence,
                 HammerKernel kernel) {
  for_each_index(out.rows(), [&](int row) {
    Line<1> line(tall.row(row).data(), tall.cols(), far_end(sequence, 'C'), out.cols());
    hammer(line, sequence, 'C', kernel);
    std::copy_n(line.places(), out.cols(), out.row(row).data());
  });
}

/// The lowest and the highest place.
std::pair<float, float> ends_of(const Grid<float>& height) {
  std::vector<std::pair<float, float>> ends(std::size_t(height.rows()));
  for_each_index(height.rows(), [&](int row) {
    float low = height(row, 0), high = low;
    for (const float h : height.row(row)) {
      low = std::min(low, h);
      high = std::max(high, h);
    }
    ends[std::size_t(row)] = {low, high};
  });
  auto [low, high] = ends.front();
  for (const auto& [a, b] : ends) {
    low = std::min(low, a);
    high = std::max(high, b);
  }
  return {low, high};
}

}  // namespace

bool is_fold_sequence(std::string_view text) {
  return !text.empty() && text.size() <= longest_sequence &&
         text.find_first_not_of("CR") == std::string_view::npos;
}

bool is_hammer_kernel(std::string_view text) {
  return text == "both" || text == "stretched";
}

HammerKernel hammer_kernel(std::string_view name) {
  return name == "stretched" ? HammerKernel::stretched : HammerKernel::both;
}

BlockSize divisible(const BlockSize& size, const std::string& sequence) {
  return {rounded_up(size.rows, halves(sequence, 'R')),
          rounded_up(size.cols, halves(sequence, 'C'))};
}

Grid<float> first_cuts(const Grid<float>& block, const std::string& sequence) {
  Grid<float> pile = block;
  for (const char cut : {'C', 'R'}) {
    if (count_of(sequence, cut) == 0) continue;
    const int rows = cut == 'R' ? pile.rows() / 2 : pile.rows();
    const int cols = cut == 'C' ? pile.cols() / 2 : pile.cols();
    Grid<float> next(rows, cols);
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        const float over =
            cut == 'C' ? pile(row, pile.cols() - 1 - col) : pile(pile.rows() - 1 - row, col);
        next(row, col) = 0.5f * (pile(row, col) + over);
      }
    }
    pile = std::move(next);
  }
  return pile;
}

Grid<float> hammered(Grid<float> pile, const std::string& sequence, HammerKernel kernel) {
  const int rows = pile.rows() * halves(sequence, 'R');
  const int cols = pile.cols() * halves(sequence, 'C');
  Grid<float> tall(rows, pile.cols());
  hammer_columns(pile, tall, sequence, kernel);
  pile = {};
  if (cols == tall.cols()) {
    hammer_rows(tall, tall, sequence, kernel);
    return tall;
  }
  Grid<float> out(rows, cols);
  hammer_rows(tall, out, sequence, kernel);
  return out;
}

Grid<float> forged_block(const Forged<>& forged, const BlockSize& size, Seed seed) {
  assert(is_fold_sequence(forged.sequence) && is_hammer_kernel(forged.kernel));
  const int down = halves(forged.sequence, 'R'), along = halves(forged.sequence, 'C');
  assert(size.rows % down == 0 && size.cols % along == 0);
  Grid<float> pile(size.rows / down, size.cols / along);
  const float spread = 1.0f / std::sqrt(float(down * along));
  for_each_index(pile.rows(), [&](int row) {
    fill_white_noise(pile.row(row), seed, row);
    for (float& value : pile.row(row)) value *= spread;
  });
  return hammered(std::move(pile), forged.sequence, hammer_kernel(forged.kernel));
}

ForgedPart forged_part(const Forged<>& forged, const BlockSize& size, Seed seed) {
  const BlockSize paper;
  const Grid<float> block =
      forged_block(forged,
                   divisible({std::max(size.rows, paper.rows), std::max(size.cols, paper.cols)},
                             forged.sequence),
                   seed);
  const auto [low, high] = ends_of(block);
  return {crop(block, 0, 0, size.rows, size.cols), low, high};
}

Surface surface_of(const Forged<>& forged, const Extent& extent, Seed seed) {
  return surface_of(forged, forged_part(forged, {extent.rows, extent.cols}, seed), extent);
}

Surface surface_of(const Forged<>& forged, ForgedPart part, const Extent& extent) {
  quantise(part, forged.levels, forged.step);
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.albedo = Image(std::move(part.height));
  surface.height = surface.albedo.planes.front();
  double sum = 0.0;
  for (const float value : surface.height) sum += value;
  const double mean = sum / double(surface.height.size());
  const double etch = forged.etch_mm / forged.levels;
  for_each_index(extent.rows, [&](int row) {
    for (float& height : surface.height.row(row)) height = float((height - mean) * etch);
    for (float& value : surface.albedo.planes.front().row(row))
      value = linear_from_srgb(value / 255.0f);
  });
  surface.normals = normals_of(surface.height, surface.mask, extent.pitch);
  return surface;
}

void quantise(Grid<float>& height, double levels, double step) {
  if (height.empty()) return;
  const auto [low, high] = ends_of(height);
  ForgedPart whole{std::move(height), low, high};
  quantise(whole, levels, step);
  height = std::move(whole.height);
}

void quantise(ForgedPart& part, double levels, double step) {
  // In double, in this order: the highest place is then exactly levels, not a rounding below it.
  const double base = part.low, range = part.high > part.low ? part.high - base : 1.0;
  const double count = step > 0.0 ? levels / step : levels;
  const float unit = step > 0.0 ? float(step) : 1.0f;
  for_each_index(part.height.rows(), [&](int row) {
    if (step > 0.0) {
      for (float& h : part.height.row(row))
        h = unit * float(int((double(h) - base) / range * count));
    } else {
      for (float& h : part.height.row(row)) h = float((double(h) - base) / range * count);
    }
  });
}

}  // namespace hada
