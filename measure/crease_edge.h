#pragma once

#include <vector>

#include <Eigen/Core>

namespace hada {

/// How far a pixel has passed from one plane to the other: 0 before the crease, 1 behind it.
struct StepSample {
  Eigen::Vector2d place;
  double passed = 0.0;
};

/// A straight edge: `normal` . place = offset, `normal` of unit length from 0 to 1.
struct CreaseEdge {
  Eigen::Vector2d normal{1.0, 0.0};
  double offset = 0.0;
  double width = 1.0;  // standard deviation of the bend
  double offset_sigma = 0.0;
  double turn_sigma = 0.0;  // of the direction, radians
  double width_sigma = 0.0;
};

/// The edge that explains the samples best: passed = Phi((normal . place - offset) / width), by
/// least squares with Huber weights from `start`.
CreaseEdge fitted_edge(const std::vector<StepSample>& samples, const CreaseEdge& start);

}  // namespace hada
