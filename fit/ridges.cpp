#include "fit/ridges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/error.h"
#include "fit/ridge_moments.h"
#include "fit/ridge_sheets.h"
#include "fit/solve.h"

namespace hada {
namespace {

using Slopes = Eigen::Matrix<double, ridge_moments, 3>;
using Gain = Eigen::Matrix<double, 3, ridge_moments>;

constexpr double most_luck = 12.592;          // of a chi-square of six, in 95 %
constexpr int rough_px = 256, full_px = 512;  // largest sides of sheets that are made to compare
constexpr int for_means = 6, for_weights = 20, for_scatter = 30;  // such sheets, none used twice
constexpr double few_more = 2.0452 / 1.9600;  // 95 % of a scatter that 30 sheets tell (Student)
constexpr int fewest_values = 1000;           // on the map, so that there is something to compare
const Ridges steps{0.04, 0.02, 0.15};         // of a difference: small beside the bounds

/// How the mean moments follow the ridges.
Slopes slopes_at(const RidgeSheets& sheets, const Ridges& at, const RidgeMoments& there) {
  Slopes slopes;
  for (int k = 0; k < 3; ++k) {
    Ridges more = at;
    const double step = at[k] > 0.0 ? -steps[k] : steps[k];
    more[k] += step;
    slopes.col(k) = (sheets.mean(more) - there) / step;
  }
  return slopes;
}

/// The ridges whose sheets have the moments `seen`, from `start`.
Ridges nearest(const RidgeSheets& sheets, const RidgeMoments& seen, const RidgeScatter& whitener,
               const Ridges& start, int iterations) {
  std::vector<SolverBounds> bounds;
  for (const auto& field : Wrinkle<>::fields()) {
    if (field.optional) bounds.push_back({field.low, field.high});
  }
  const ResidualFunction evaluate = [&](const double* packed, double* residuals, double* jacobian) {
    const Ridges at(packed[0], packed[1], packed[2]);
    const RidgeMoments there = sheets.mean(at);
    Eigen::Map<RidgeMoments> r(residuals);
    r = whitener * (there - seen);
    if (!jacobian) return;
    Eigen::Map<Eigen::Matrix<double, ridge_moments, 3, Eigen::RowMajor>> j(jacobian);
    j = whitener * slopes_at(sheets, at, there);
  };
  const Ending end = descend({{start[0], start[1], start[2]}}, bounds, ridge_moments, evaluate,
                             {.max_iterations = iterations, .tolerance = 1e-2})
                         .front();
  return {end.packed[0], end.packed[1], end.packed[2]};
}

/// The sharpness that alone explains the moments best, of a few.
Ridges start_for(const RidgeSheets& sheets, const RidgeMoments& seen,
                 const RidgeScatter& whitener) {
  Ridges best = Ridges::Zero();
  double least = HUGE_VAL;
  for (const double sharpness : {0.3, -0.3, 1.0, -1.0, 2.0, -2.0, 3.5, -3.5}) {
    const Ridges at(0.0, 0.0, sharpness);
    const double cost = (whitener * (sheets.mean(at) - seen)).squaredNorm();
    if (cost < least) {
      least = cost;
      best = at;
    }
  }
  return best;
}

double distance(std::vector<float> a, std::vector<float> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  constexpr int quantiles = 1000;
  double sum = 0.0;
  for (int k = 0; k < quantiles; ++k) {
    const double share = (k + 0.5) / quantiles;
    sum += std::abs(a[std::size_t(share * double(a.size()))] -
                    b[std::size_t(share * double(b.size()))]);
  }
  return sum / quantiles;
}

RidgeEvidence::Histograms apart(const RidgeValues& seen, const RidgeSheets& sheets,
                                const Ridges& ridges) {
  RidgeValues all;
  const auto add = [](std::vector<float>& to, const std::vector<float>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (int k = 0; k < sheets.kept(); ++k) {
    const auto values = sheets.values(k, ridges);
    add(all.heights, values.heights);
    add(all.curvatures, values.curvatures);
    for (std::size_t i = 0; i < 2; ++i) add(all.slopes[i], values.slopes[i]);
  }
  return {distance(seen.heights, all.heights),
          0.5 * (distance(seen.slopes[0], all.slopes[0]) + distance(seen.slopes[1], all.slopes[1])),
          distance(seen.curvatures, all.curvatures)};
}

RidgeScatter scatter_of(const RidgeSheets::Columns& columns) {
  const auto centred = (columns.colwise() - columns.rowwise().mean()).eval();
  return centred * centred.transpose() / double(columns.cols() - 1);
}

/// What the spectrum is not known to, in the moments: those of sheets a sigma away along every
/// principal axis of its covariance.
RidgeScatter scatter_of_spectrum(const Fit<Wrinkle<>>& spectrum, const Extent& tile, int smoothings,
                                 const Ridges& ridges) {
  constexpr double most = 0.5;  // that an axis is followed, in logarithms and radians
  RidgeScatter scatter = RidgeScatter::Zero();
  if (spectrum.covariance.size() == 0) return scatter;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(spectrum.covariance);
  const auto packed = pack(spectrum.material);
  const auto mean_at = [&](const Wrinkle<>& wrinkle) {
    return RidgeSheets(wrinkle, tile, smoothings, for_means / 2).mean(ridges);
  };
  const RidgeMoments here = mean_at(spectrum.material);
  for (Eigen::Index i = 0; i < axes.eigenvalues().size(); ++i) {
    const double sigma = std::min(std::sqrt(std::max(axes.eigenvalues()[i], 0.0)), most);
    if (sigma < 1e-6) continue;
    auto moved = packed;
    for (std::size_t k = 0; k < moved.size(); ++k)
      moved[k] += sigma * axes.eigenvectors()(Eigen::Index(k), i);
    const RidgeMoments away = mean_at(unpack(spectrum.material, moved.data())) - here;
    scatter += away * away.transpose();
  }
  return scatter;
}

/// A tenth without its correlations: of few sheets those are rough.
RidgeScatter without_rough_correlations(const RidgeScatter& scatter) {
  const RidgeScatter alone = scatter.diagonal().asDiagonal();
  return 0.9 * scatter + 0.1 * alone;
}

RidgeScatter whitener_of(const RidgeScatter& scatter) {
  return scatter.llt().matrixL().solve(RidgeScatter::Identity());
}

Extent tile_of(const Extent& extent, int most_px) {
  return {std::min(extent.rows, most_px), std::min(extent.cols, most_px), extent.pitch,
          extent.unit};
}

}  // namespace

RidgeFit fit_ridges(const Grid<float>& height, const Mask& mask, const Fit<Wrinkle<>>& spectrum,
                    const Extent& extent, const FitProgress& progress) {
  const auto tell = [&](const char* stage) {
    if (progress) progress(stage);
  };
  RidgeFit fit;
  const Wrinkle<>& wrinkle = spectrum.material;
  const int smoothings = smoothings_for(wrinkle, extent.pitch);
  const RidgeValues values = ridge_values(height, mask, smoothings);
  if (int(values.heights.size()) < fewest_values)
    throw Error("ridges: only " + std::to_string(values.heights.size()) +
                " pixels are left of the map once it is smoothed, at least 1000 are needed");
  const double area = double(values.heights.size()) * extent.pitch * extent.pitch;
  const RidgeMoments seen = moments_of(values);
  const auto gaussian = whitener_of(gaussian_scatter(wrinkle, extent, area, smoothings));

  tell("comparing its heights, slopes and curvatures with ridged sheets");
  const Extent small = tile_of(extent, rough_px), tile = tile_of(extent, full_px);
  const RidgeSheets rough(wrinkle, small, smoothings, for_means / 2);
  const RidgeSheets sheets(wrinkle, tile, smoothings, for_means);
  Ridges found = nearest(rough, seen, gaussian, start_for(rough, seen, gaussian), 5);

  // The same with weights of sheets with such ridges, whose moments scatter more.
  tell("comparing it with sheets of its size");
  const double share = tile.width() * tile.height() / area;  // how much less luck the map has
  const double luck = share + 1.0 / for_means;               // of the map and of those sheets
  const RidgeScatter of_spectrum = scatter_of_spectrum(spectrum, small, smoothings, found);
  const auto scatter = [&](int first, int count) {
    return RidgeScatter(luck * scatter_of(sheets.moments(first, count, found)) + of_spectrum);
  };
  const auto whitener = whitener_of(without_rough_correlations(scatter(for_means, for_weights)));
  found = nearest(sheets, seen, whitener, found, 3);

  // Weights that other sheets gave are not exact: sigma is what the scatter of yet others becomes.
  tell("telling how sure that is");
  const RidgeMoments there = sheets.mean(found);
  const Slopes slopes = whitener * slopes_at(sheets, found, there);
  const Gain gain = (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * whitener);
  fit.covariance =
      few_more * few_more * gain * scatter(for_means + for_weights, for_scatter) * gain.transpose();
  fit.sigma = fit.covariance.diagonal().cwiseSqrt();
  fit.value = found;
  fit.evidence.departure = (gaussian * seen).squaredNorm();
  fit.evidence.left = (gaussian * (seen - there)).squaredNorm();
  fit.evidence.gaussian = apart(values, sheets, Ridges::Zero());
  fit.evidence.ridged = apart(values, sheets, found);
  return fit;
}

std::string told(const RidgeFit& ridges) {
  const RidgeEvidence& e = ridges.evidence;
  if (e.departure < most_luck) {
    return fmt::format(
        "Heights, slopes and curvatures are those of a Gaussian sheet as far as can be told "
        "(chi-square {:.1f} of 6): read its ridges as none.",
        e.departure);
  }
  return fmt::format(
      "Beyond its spectrum: ridges explain {:.0f} % of how heights, slopes and curvatures depart "
      "from a Gaussian sheet (chi-square {:.0f} to {:.0f}, 6 moments).",
      100.0 * e.explained(), e.departure, e.left);
}

}  // namespace hada
