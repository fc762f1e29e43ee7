#include "sheet/crossing.h"

#include "sheet/plate.h"

namespace hada {

std::vector<std::array<int, 2>> crossing_faces(const Sheet& sheet, double tolerance) {
  const auto plates = plates_of(sheet);
  std::vector<std::array<int, 2>> crossing;
  for (std::size_t a = 0; a < plates.size(); ++a) {
    for (std::size_t b = a + 1; b < plates.size(); ++b) {
      if (pierce(plates[a], plates[b], tolerance)) crossing.push_back({int(a), int(b)});
    }
  }
  return crossing;
}

}  // namespace hada
