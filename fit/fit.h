#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hada {

/// Is told what a fit is at, in a few words for a person.
using FitProgress = std::function<void(const std::string& stage)>;

/// A field is in here with 95 %, in its natural unit; an angle's ends are not wrapped.
struct FieldInterval {
  std::string path;
  double low, high;
};

/// The best of several starts, and how sure it is. M is a material over double.
template <class M>
struct Fit {
  M material;
  M sigma;                            // standard deviation, field by field
  std::vector<std::string> on_bound;  // paths of fields that ended on a bound: their sigma is void
  std::vector<FieldInterval> intervals;  // of fields near a bound, where +-1.96 sigma is none
  double cost = 0.0;                     // of the best start (half the sum of squared residuals)
  double runner_up_gap = 0.0;            // cost of the best clearly different ending minus `cost`
  int starts = 0;                        // how many were run
  int agreeing = 0;                      // how many of them ended at the best
  double goodness_p = std::numeric_limits<double>::quiet_NaN();  // small: the model is wrong
  Eigen::MatrixXd covariance;                                    // of the packed fields
  std::vector<std::string> remarks;                              // plain sentences for a person
};

}  // namespace hada
