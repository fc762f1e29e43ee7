#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace hada {

/// How normals are found from the samples of a pixel.
///
/// All but the first leave out what the stack marks as shadowed or saturated.
enum class Estimator {
  least_squares,      // all samples: the paper's N^+ I, and the baseline
  lit_least_squares,  // the samples that are lit and not saturated
  trimmed,            // those between two ranks of brightness
  huber,              // reweighted, Huber 1964
  cauchy,             // reweighted, the likelihood of Cauchy noise
  l1,                 // least absolute residuals
  biweight,           // reweighted, Beaton and Tukey 1974: far residuals count nothing
  sparse_bayesian,    // a sparse error per sample, Ikehata et al. 2012
  robust_pca,         // a low rank over all pixels, Wu et al. 2010
  adaptive,           // biweight, with one shading curve and the light between folds for all pixels
};

inline constexpr std::array every_estimator = {
    Estimator::least_squares, Estimator::lit_least_squares,
    Estimator::trimmed,       Estimator::huber,
    Estimator::cauchy,        Estimator::l1,
    Estimator::biweight,      Estimator::sparse_bayesian,
    Estimator::robust_pca,    Estimator::adaptive,
};

inline constexpr Estimator default_estimator = Estimator::adaptive;

/// "least-squares", "lit-least-squares", "trimmed", ...: as on the command line.
std::string_view name_of(Estimator estimator);

/// The inverse of `name_of`; nothing for a name that is not known.
std::optional<Estimator> estimator_named(std::string_view name);

/// All names, with commas between.
std::string estimator_names();

}  // namespace hada
