#include "sheet/strain.h"

#include <algorithm>
#include <cmath>

#include "sheet/arrangement.h"
#include "sheet/plate.h"

namespace hada {

std::vector<double> face_strains(const Sheet& sheet) {
  std::vector<double> strains;
  for (int f = 0; f < sheet.faces(); ++f) {
    const auto corners = sheet.corners_of(f);
    double most = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t a = std::size_t(corners[i]), b = std::size_t(corners[j]);
        const double was = (sheet.flat[a] - sheet.flat[b]).norm();
        most = std::max(most, std::abs((sheet.folded[a] - sheet.folded[b]).norm() / was - 1.0));
      }
    }
    strains.push_back(most);
  }
  return strains;
}

std::vector<double> face_planarities(const Sheet& sheet) {
  const double size = size_of(sheet.flat);
  std::vector<double> planarities;
  for (const Plate& plate : plates_of(sheet)) {
    double most = 0.0;
    for (const Eigen::Vector3d& p : plate.corners) {
      most = std::max(most, std::abs(plate.normal.dot(p - plate.centre)));
    }
    planarities.push_back(most / size);
  }
  return planarities;
}

}  // namespace hada
