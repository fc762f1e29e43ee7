#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"
#include "core/random.h"
#include "fit/ridge_moments.h"
#include "synth/wrinkle.h"

namespace hada {

/// Skew, tail and sharpness of a wrinkle.
using Ridges = Eigen::Vector3d;

Wrinkle<> with(Wrinkle<> wrinkle, const Ridges& ridges);

/// Sheets of one spectrum that are made for comparison. Sheet k has the same luck under every
/// ridge and every spectrum, so that differences are those of the ridges and the spectrum.
class RidgeSheets {
 public:
  using Columns = Eigen::Matrix<double, ridge_moments, Eigen::Dynamic>;

  /// kept  the first so many fields are made once and remembered
  RidgeSheets(const Wrinkle<>& wrinkle, const Extent& extent, int smoothings, int kept);

  RidgeValues values(int sheet, const Ridges& ridges) const;

  /// The moments of the sheets first, first + 1, ..., a column each.
  Columns moments(int first, int count, const Ridges& ridges) const;
  /// Their mean over the sheets that are kept.
  RidgeMoments mean(const Ridges& ridges) const;

  int kept() const { return int(fields_.size()); }

 private:
  Grid<float> field(int sheet) const;
  Grid<float> floor(int sheet) const;

  Wrinkle<> wrinkle_;
  Extent extent_;
  int smoothings_;
  std::vector<Grid<float>> fields_, floors_;
};

}  // namespace hada
