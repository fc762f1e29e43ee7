#include "capture/joint_problem.h"

#include <cmath>

#include <gtest/gtest.h>

#include "made_evidence.h"

namespace hada {
namespace {

TEST(JointProblem, LeavesNothingOverAtTheTruth) {
  MadeEvidence made = made_evidence(0.0, 1.0 / 300.0, 1);
  made.truth.spheres[0].sigma = made.truth.sheet_sigma = 1e-3;
  made.truth.strength_sigma = 1e9;         // the truth's strengths are not all 1
  made.truth.spheres[0].surface[1] = 0.5;  // where its prior lies
  for (auto& picture : made.evidence.matte[0].thrown) {
    for (double& value : picture) value *= 0.4 / 0.5;
  }
  JointProblem joint(made.truth, made.evidence, LampModel::near);
  double cost = 0.0;
  joint.problem.Evaluate({}, &cost, nullptr, nullptr, nullptr);
  // But for the prior on six inverse distances, of half an inverse radius.
  const double prior = 0.5 * 6.0 * std::pow((1.0 / 300.0) / (0.5 / 5.0), 2);
  EXPECT_NEAR(cost, prior, 1e-12);
}

TEST(JointProblem, NamesARowForEveryResidual) {
  MadeEvidence made = made_evidence(0.001, 0.0, 1);
  JointProblem joint(made.truth, made.evidence, LampModel::distant);
  EXPECT_EQ(int(joint.rows.size()), joint.problem.NumResiduals());
  EXPECT_EQ(int(joint.blocks.size()), joint.problem.NumResidualBlocks());
  EXPECT_EQ(joint.sheet.size(), made.evidence.sheet.points.size());
}

}  // namespace
}  // namespace hada
