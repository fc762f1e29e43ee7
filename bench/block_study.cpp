#include "bench/block_study.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "core/error.h"
#include "core/quantile.h"
#include "fit/block.h"
#include "fit/block_cut.h"
#include "io/json.h"
#include "io/surface_file.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double ninety = 1.6449;  // deviations that hold 90 % of a Gaussian

/// The six faces, in px.
std::vector<PlacedFace> block_cn03(const std::filesystem::path& folder) {
  constexpr double half = 128.0;
  const auto face = [&](const char* name, const StemVector& origin, const StemVector& right,
                        const StemVector& up) {
    return PlacedFace{name, read_surface(folder / (std::string(name) + "_col.png")),
                      cut_along(origin, right, up)};
  };
  // Unfolded as a cross: C A E F around, B above A, D below it.
  return {face("B", {0, 0, half}, {1, 0, 0}, {0, 1, 0}),
          face("A", {0, -half, 0}, {1, 0, 0}, {0, 0, 1}),
          face("C", {-half, 0, 0}, {0, -1, 0}, {0, 0, 1}),
          face("D", {0, 0, -half}, {1, 0, 0}, {0, -1, 0}),
          face("E", {half, 0, 0}, {0, 1, 0}, {0, 0, 1}),
          face("F", {0, half, 0}, {-1, 0, 0}, {0, 0, 1})};
}

LeftOut predict_left_out(const std::vector<PlacedFace>& faces, const BlockFit& all,
                         std::size_t which) {
  LeftOut score{.face = faces[which].name};
  auto others = faces;
  others.erase(others.begin() + std::ptrdiff_t(which));
  const BlockFit block = fit_block(others);
  const auto& out = faces[which];
  const double pitch = out.surface.extent.pitch;
  std::vector<double> errors, shares;
  int held = 0;
  for (const RingSighting& seen :
       ring_sightings(block_face(out), 0, all.solid, all.mark, all.faces[which].scatter)) {
    const SolidLocal local = local_of(block.solid, seen.place);
    const Eigen::Map<const Eigen::Vector3d> across(seen.across.data());
    const double slope = std::max(std::abs(local.gradient.dot(across)), 0.03);
    const double off = std::abs(local.rho - block.solid.radii[seen.ring]) / slope;
    const double sigma =
        std::hypot(ring_sigma(block.solid, local, seen.ring), block.solid.radii_loose[seen.ring]) /
        slope;
    const double inner = seen.ring > 0 ? block.solid.radii[seen.ring - 1] : 0.0;
    errors.push_back(off / pitch);
    shares.push_back(off * slope / (block.solid.radii[seen.ring] - inner));
    if (off <= ninety * sigma) ++held;
  }
  score.places = int(errors.size());
  if (!errors.empty()) {
    score.error = median(errors);
    score.width = median(shares);
    score.coverage = double(held) / double(errors.size());
  }
  const auto cut = predicted(block, out.cut, out.surface.extent);
  if (cut.slopes.empty()) return score;
  try {
    score.slope = face_grain(out.surface).gradient.value;
    score.has_slope = true;
  } catch (const Error&) {  // its fibres cannot be seen
  }
  score.expected = cut.mean_slope.value;
  score.expected_sigma = cut.mean_slope.sigma;
  return score;
}

}  // namespace

std::vector<LeftOut> left_out_faces(const std::filesystem::path& folder) {
  std::vector<LeftOut> scores;
  if (!std::filesystem::exists(folder)) return scores;
  const auto faces = block_cn03(folder);
  const BlockFit all = fit_block(faces);
  for (std::size_t k = 1; k < faces.size(); ++k) scores.push_back(predict_left_out(faces, all, k));
  return scores;
}

SolidScore score_solid(const std::filesystem::path& folder, const char* name) {
  const Json truths = Json::parse(std::ifstream(folder / "truth" / "truth.json"));
  const Json& truth = truths["blocks"][name];
  const auto block = fit_block(
      {{"end", read_surface(folder / name / "end_grain.png", truth["pixel_mm_end"].get<double>()),
        Cut()},
       {"face",
        read_surface(folder / name / "tangential.png", truth["pixel_mm_tangential"].get<double>()),
        cut_along({truth["x_face_mm"].get<double>(), 0, 0}, {0, 1, 0}, {0, 0, 1})}});
  const auto pith = truth["pith_mm"].get<std::vector<double>>();
  const auto lean = truth["pith_drift_mm_per_mm"].get<std::vector<double>>();
  const auto radii = truth["ring_boundary_radii_mm"].get<std::vector<double>>();
  GrowthSolid real;
  real.frame.pith = {pith[0], pith[1]};
  real.lean = {lean[0], lean[1]};
  real.taper = truth["taper_mm_per_mm"].get<double>();
  for (const double order : {2.0, 3.0}) {
    const std::string k = order == 2.0 ? "2" : "3";
    const double height = truth["out_of_round"]["e" + k].get<double>();
    const double angle = order * truth["out_of_round"]["p" + k + "_deg"].get<double>() * degree;
    real.frame.lobes.push_back({order, height * std::cos(angle), height * std::sin(angle)});
  }
  SolidScore score;
  score.lean = (block.solid.lean - real.lean).norm();
  score.taper = std::abs(block.solid.taper - real.taper);
  const Cut slanted = cut_along({10, 0, 5}, {0, 1, 0}, {0.5, 0, 1});
  const auto cut = predicted(block, slanted, {400, 400, 0.1, Unit::mm});
  std::vector<double> errors;
  int held = 0;
  for (const RingStation& station : cut.rings) {
    const double rho = local_of(real, slanted.at(station.place.x(), station.place.y()), false).rho;
    double off = HUGE_VAL;
    for (const double radius : radii) off = std::min(off, std::abs(rho - radius));
    errors.push_back(off / station.slope);
    if (errors.back() <= ninety * station.sigma) ++held;
  }
  score.line_mm = median(errors);
  score.coverage = double(held) / double(errors.size());
  return score;
}

}  // namespace hada
