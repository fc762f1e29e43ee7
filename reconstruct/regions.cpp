#include "reconstruct/regions.h"

#include <algorithm>
#include <cstring>

namespace hada {
namespace {

// Runs that touch are linked to the earliest run of their region.
class Links {
 public:
  void add() { earlier_.push_back(earlier_.size()); }
  std::size_t first_of(std::size_t run) {
    while (earlier_[run] != run) run = earlier_[run] = earlier_[earlier_[run]];
    return run;
  }
  void join(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax({first_of(a), first_of(b)});
    earlier_[high] = low;
  }

 private:
  std::vector<std::size_t> earlier_;
};

// The first column from `col` on that is in the mask; the number of columns if none is.
int first_pixel(std::span<const std::uint8_t> pixels, int col) {
  const auto begin = pixels.begin() + col;
  return col +
         int(std::find_if(begin, pixels.end(), [](std::uint8_t p) { return p != 0; }) - begin);
}

// The same for one that is not.
int first_hole(std::span<const std::uint8_t> pixels, int col) {
  const auto* const begin = pixels.data() + col;
  const void* const hole = std::memchr(begin, 0, pixels.size() - std::size_t(col));
  return hole ? col + int(static_cast<const std::uint8_t*>(hole) - begin) : int(pixels.size());
}

}  // namespace

Regions regions_of(const Mask& mask) {
  Regions regions;
  regions.starts.push_back(0);
  Links links;
  for (int row = 0; row < mask.rows(); ++row) {
    const auto pixels = mask.row(row);
    const std::size_t begin = regions.runs.size();
    for (int col = 0; col < mask.cols();) {
      const int first = first_pixel(pixels, col);
      if (first == mask.cols()) break;
      col = first_hole(pixels, first);
      regions.runs.push_back({first, col, 0});
      links.add();
    }
    std::size_t above = row > 0 ? regions.starts[std::size_t(row) - 1] : begin;
    for (std::size_t run = begin; run < regions.runs.size(); ++run) {
      const auto [first, last, none] = regions.runs[run];
      while (above < begin && regions.runs[above].last <= first) ++above;
      for (std::size_t a = above; a < begin && regions.runs[a].first < last; ++a) {
        links.join(a, run);
      }
    }
    regions.starts.push_back(regions.runs.size());
  }
  regions.size.push_back(int(mask.size()));
  for (std::size_t run = 0; run < regions.runs.size(); ++run) {
    Regions::Run& r = regions.runs[run];
    const std::size_t first = links.first_of(run);
    if (first == run) {
      r.region = int(regions.size.size());
      regions.size.push_back(0);
    } else {
      r.region = regions.runs[first].region;
    }
    regions.size[std::size_t(r.region)] += r.last - r.first;
    regions.size[0] -= r.last - r.first;
  }
  return regions;
}

int Regions::label(int row, int col) const {
  const auto runs_of_row = this->row(row);
  const auto run = std::partition_point(runs_of_row.begin(), runs_of_row.end(),
                                        [col](const Run& r) { return r.last <= col; });
  return run != runs_of_row.end() && run->first <= col ? run->region : 0;
}

}  // namespace hada
