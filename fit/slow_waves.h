#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "fit/cells.h"
#include "measure/spectrum.h"
#include "synth/wrinkle.h"

namespace hada {

/// The slowest ordinates of a spectrum as they are: sums over the levelled and tapered heights.
///
/// Where wrinkles are long beside a map, their power lies on a few ordinates that know of each
/// other, and a plane that was taken off took some of it. Both follow from the autocovariance
/// without a word about smoothness: the covariance of two ordinates is the integral of S times
/// their sensitivities to each frequency.
class SlowWaves {
 public:
  /// levelling  what was removed from the heights, as `Surface` tells it
  SlowWaves(const Spectrum& spectrum, const std::string& levelling);

  /// `cells` with the correction of the slow ones multiplied by what levelling left of their power.
  std::vector<Cell> levelled(std::vector<Cell> cells, const Wrinkle<>& wrinkle) const;

  /// What is known of the fields of `wrinkle` by a fit to `cells`, which takes ordinates for
  /// independent and corrections for constants.
  ///
  /// jacobian      of the whitened logarithms, a row for each of `cells`
  /// independence  of an ordinate, as the likelihood has it
  /// returns       the inverse of the covariance of the packed fields: R^T (J^T J + X)^-1 R, with X
  ///               the scatter of the score beyond J^T J and R how it follows the fields
  ///
  /// Source: Godambe, Ann. Math. Stat. 31 (1960).
  Eigen::MatrixXd information(const std::vector<Cell>& cells, const Wrinkle<>& wrinkle,
                              const Eigen::MatrixXd& jacobian, double independence) const;

 private:
  int ordinate_of(const Cell& cell) const;  // -1: none of the slow
  Eigen::VectorXd powers(const Wrinkle<>& wrinkle) const;
  Eigen::VectorXd expected(const Eigen::VectorXd& power) const;
  Eigen::MatrixXd slopes(const Wrinkle<>& wrinkle) const;

  Extent extent_;
  std::vector<Eigen::Vector2i> ordinates_;  // steps of frequency along x and y
  Eigen::MatrixXd seen_;        // by real and imaginary parts, a row each: of cosines, then sines
  Eigen::MatrixXd squared_;     // the same squared and added up for each wave
  Eigen::MatrixXd unlevelled_;  // squared sensitivity of ordinates before levelling
  Eigen::MatrixXd smooth_;      // squared coherence of ordinates under a smooth spectrum
};

}  // namespace hada
