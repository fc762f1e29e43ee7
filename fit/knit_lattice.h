#pragma once

#include <Eigen/Core>

#include "fit/knit_harmonics.h"
#include "fit/knit_picture.h"
#include "synth/knit.h"

namespace hada {

/// Where the knit lies that explains a picture best as a sum of its harmonics.
struct LatticeFit {
  Knit<> knit;                             // its lattice; the rest is as it was
  Eigen::Matrix<double, 6, 6> covariance;  // of `lattice_fields`, with stitches as the samples
  double explained = 0.0;                  // share of the variance of the picture
  bool wanders = false;  // stitches are too uneven: `knit` is the guess, their mean
};

/// The wale and course distance, rotation, skew and gradients of the periodic pattern in `picture`.
///
/// Every plane is a slowly changing background and the strongest harmonics of one pattern, whose
/// place is bent by the six numbers; both are solved for at once by Gauss and Newton (the linear
/// part projected out), in windows around the middle that grow to the whole. Stitches, and not
/// pixels, are what is independent: the covariance is the sandwich over blocks of two by two.
///
/// guess  its course distance is that of one whole period up the wales, colours included
///
/// Source: Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973); Liang and Zeger, Biometrika 73
/// (1986).
LatticeFit fit_lattice(const KnitPicture& picture, const Knit<>& guess);

}  // namespace hada
