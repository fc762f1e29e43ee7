#include "reconstruct/wavefront.h"

#include <algorithm>
#include <cstdint>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr std::size_t least_cells = 200000;  // of a band: below, the start of a thread costs more

}  // namespace

void run_wavefront(int rows, std::size_t cells, const std::vector<Stage>& stages) {
  const int count = int(stages.size());
  std::vector<int> lag(stages.size(), 0);  // behind the first stage, in rows
  for (int s = 1; s < count; ++s) {
    lag[std::size_t(s)] = lag[std::size_t(s - 1)] + stages[std::size_t(s)].reach;
  }
  const int last_lag = lag.back();
  const int bands = int(
      std::clamp<std::size_t>(std::min(cells / least_cells, std::size_t(rows / (4 * last_lag + 4))),
                              1, std::size_t(threads())));
  const auto border = [&](int band) { return int(std::int64_t(rows) * band / bands); };
  for_slices(bands, [&](int begin, int end) {
    for (int band = begin; band < end; ++band) {
      const int first = border(band);
      const int last = border(band + 1);
      for (int front = first; front < last + last_lag; ++front) {
        for (int s = 0; s < count; ++s) {
          const int behind = lag[std::size_t(s)];
          const int row = front - behind;
          const bool reached = row >= first + (band > 0 ? behind : 0) &&
                               row < last - (band + 1 < bands ? behind : 0);
          if (reached) stages[std::size_t(s)].work(row);
        }
      }
    }
  });
  for (int band = 1; band < bands; ++band) {
    for (int s = 1; s < count; ++s) {
      const int behind = lag[std::size_t(s)];
      for (int row = border(band) - behind; row < border(band) + behind; ++row) {
        stages[std::size_t(s)].work(row);
      }
    }
  }
}

}  // namespace hada
