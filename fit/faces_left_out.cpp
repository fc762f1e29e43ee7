#include "fit/faces_left_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr double ninety = 1.6449;   // deviations that hold 90 % of a Gaussian
constexpr std::size_t fewest = 20;  // sightings on a face, and on the others
constexpr int parts = 20;           // of the sightings of a face, each by its quantile
constexpr double least = 0.5, most = 5.0;

/// Deviations that hold 90 % of Student's t of 1, 2, ... degrees of freedom.
constexpr std::array student = {6.314, 2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860};

/// For each of `own`: by how much the band of its ring must be widened to hold it.
std::vector<double> surprises(const GrowthSolid& solid, const std::vector<RingSighting>& own,
                              double scatter) {
  std::vector<double> all;
  for (const RingSighting& seen : own) {
    const SolidLocal local = local_of(solid, seen.place);
    const double slope = local.gradient.dot(Eigen::Map<const Eigen::Vector3d>(seen.across.data()));
    const double off = (local.rho - solid.radii[seen.ring]) / ninety, noise = scatter * slope;
    all.push_back(std::sqrt(std::max(off * off - noise * noise, 0.0)) /
                  std::max(ring_sigma(solid, local, seen.ring), 1e-12));
  }
  return all;
}

}  // namespace

double surprise_of_faces(const std::vector<RingSighting>& sightings,
                         const std::vector<RingThread>& threads, const GrowthSolid& start,
                         const SolidPrior& prior, const std::vector<FaceScatter>& faces,
                         double noise) {
  std::vector<double> shares;
  std::size_t asked = 0;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    std::vector<RingSighting> own, others;
    std::vector<RingThread> threads_of_others;
    std::partition_copy(sightings.begin(), sightings.end(), std::back_inserter(own),
                        std::back_inserter(others),
                        [&](const RingSighting& one) { return one.face == face; });
    if (own.size() < fewest || others.size() < fewest) continue;
    std::copy_if(threads.begin(), threads.end(), std::back_inserter(threads_of_others),
                 [&](const RingThread& one) { return one.face != face; });
    const SolidFit fit = fitted_solid(others, start, prior, faces.size(), noise, threads_of_others);
    const auto all = surprises(fit.solid, own, faces[face].scatter);
    for (int k = 0; k < parts; ++k) shares.push_back(quantile(all, (k + 0.5) / parts));
    ++asked;
  }
  if (asked < 2) return 1.0;
  const double wider = student[std::min(asked - 1, student.size()) - 1] / ninety;
  return std::clamp(wider * quantile(std::move(shares), 0.9), least, most);
}

}  // namespace hada
