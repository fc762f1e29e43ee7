#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace hada {

/// One pass over the rows of a grid: `work(row)` may read what earlier stages left in the rows up
/// to `reach` away, and changes nothing that an earlier stage still has to read there.
struct Stage {
  int reach = 1;
  std::function<void(int row)> work;
};

/// Runs stages one after another, each over all rows, as far as the result goes; but row by row in
/// a staggered front, so that the rows are read from memory once for all stages.
///
/// Threads take bands of rows. Near the border of a band a stage stops a little earlier than the
/// one before; what is missing there is done when all bands are finished. Every row meets the same
/// values whatever the number of bands.
///
/// cells  of all rows together: small grids are not worth a second thread
void run_wavefront(int rows, std::size_t cells, const std::vector<Stage>& stages);

}  // namespace hada
