#include "mechanics/knit_pull.h"

#include <cmath>

#include "core/error.h"

namespace hada {

PulledKnit pulled(KnitNet net, KnitPull pull, KnitClamp clamp, double stretch) {
  if (!(stretch >= 1.0) || !std::isfinite(stretch)) {
    throw Error("a stretch must be a number from 1 on, as 1.2: a knit that is pushed folds");
  }
  const bool along = pull == KnitPull::course;
  const double dx = net.wale_length * (along ? stretch : 1.0);
  const double dy = net.course_length * (along ? 1.0 : stretch);
  Places start;
  for (int i = 0; i < net.points(); ++i) {
    start.emplace_back(dx * (i % net.wales - 0.5 * (net.wales - 1)),
                       dy * (i / net.wales - 0.5 * (net.courses - 1)), 0.0);
  }
  net.pinned.assign(start.size(), false);
  const int across = along ? net.courses : net.wales;
  const int last = (along ? net.wales : net.courses) - 1;
  for (int k = 0; k < across; ++k) {
    if (clamp == KnitClamp::three_points && k != 0 && k != across / 2 && k != across - 1) continue;
    for (const int end : {0, last}) {
      net.pinned[std::size_t(along ? k * net.wales + end : end * net.wales + k)] = true;
    }
  }
  return {std::move(net), std::move(start)};
}

}  // namespace hada
