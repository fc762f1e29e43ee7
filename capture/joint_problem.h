#pragma once

#include <vector>

#include <ceres/ceres.h>

#include "capture/joint_fit.h"

namespace hada {

/// The least-squares problem of a joint fit, over a state that must outlive it.
///
/// Included by sources only.
struct JointProblem {
  /// Residuals of one cluster lie close together on one thing and may hang together.
  struct Row {
    enum class Kind { matte, chrome, sheet, other } kind;
    int cluster;
  };

  // Outliers (dust, gloss, shadow) lose their pull from three sigma on.
  static constexpr double robust_width = 3.0;

  ceres::Problem problem;
  std::vector<ceres::ResidualBlockId> blocks;  // of residuals
  std::vector<Row> rows;                       // of the Jacobian, in the order of `blocks`
  std::vector<double*> shared;                 // the unknowns but the sheet's
  std::vector<double*> sheet;                  // four unknowns of each pixel

  JointProblem(JointState& state, const Evidence& evidence, LampModel model);

 private:
  void add(ceres::CostFunction* cost, ceres::LossFunction* loss, Row row,
           const std::vector<double*>& unknowns);
  void add_matte(JointState& state, const MatteEvidence& seen);
  void add_chrome(JointState& state, const ChromeEvidence& seen);
  void add_sheet(JointState& state, const SheetEvidence& seen);
  void add_priors(JointState& state);
};

}  // namespace hada
