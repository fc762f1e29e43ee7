#include "reconstruct/estimator.h"

namespace hada {

std::string_view name_of(Estimator estimator) {
  switch (estimator) {
    case Estimator::least_squares:
      return "least-squares";
    case Estimator::lit_least_squares:
      return "lit-least-squares";
    case Estimator::trimmed:
      return "trimmed";
    case Estimator::huber:
      return "huber";
    case Estimator::cauchy:
      return "cauchy";
    case Estimator::l1:
      return "l1";
    case Estimator::biweight:
      return "biweight";
    case Estimator::sparse_bayesian:
      return "sparse-bayesian";
    case Estimator::robust_pca:
      return "robust-pca";
    case Estimator::adaptive:
      break;
  }
  return "adaptive";
}

std::optional<Estimator> estimator_named(std::string_view name) {
  for (const Estimator estimator : every_estimator) {
    if (name_of(estimator) == name) return estimator;
  }
  return std::nullopt;
}

std::string estimator_names() {
  std::string names;
  for (const Estimator estimator : every_estimator) {
    if (!names.empty()) names += ", ";
    names += name_of(estimator);
  }
  return names;
}

}  // namespace hada
