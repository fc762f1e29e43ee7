#include "reconstruct/turned_y.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "core/quantile.h"

namespace hada {

double gain_of_turned_y(const NormalMap& normals, const Mask& mask) {
  assert(normals.same_size(mask));
  constexpr int enough_rows = 512;
  const int step = std::max(1, mask.rows() / enough_rows);
  std::vector<float> given, turned;  // squares of the curl
  for (int row = 0; row + 1 < mask.rows(); row += step) {
    for (int col = 0; col + 1 < mask.cols(); ++col) {
      if (!mask(row, col) || !mask(row, col + 1) || !mask(row + 1, col) ||
          !mask(row + 1, col + 1)) {
        continue;
      }
      // Of each corner the slopes -x/z and -y/z; y is up, so the upper row comes first.
      std::array<float, 4> p{}, q{};
      for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3f& n = normals(row + int(i / 2), col + int(i % 2));
        p[i] = -n.x() / n.z();
        q[i] = -n.y() / n.z();
      }
      const float along_y = (p[0] + p[1]) - (p[2] + p[3]);
      const float along_x = (q[1] + q[3]) - (q[0] + q[2]);
      given.push_back((along_y - along_x) * (along_y - along_x));
      turned.push_back((along_y + along_x) * (along_y + along_x));
    }
  }
  if (given.empty()) return 1.0;
  const float nothing = 1e-12f;  // rounding
  return double(median(std::move(given)) + nothing) / double(median(std::move(turned)) + nothing);
}

}  // namespace hada
