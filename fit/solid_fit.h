#pragma once

#include <cstddef>
#include <vector>

#include "fit/growth_solid.h"

namespace hada {

/// A place on a picture of the stem where a ring ends.
struct RingSighting {
  StemVector place;
  std::size_t face = 0;  // the picture
  std::size_t ring = 0;
  int run = 0;                       // those of one run follow each other along a ring
  StemVector across{1.0, 0.0, 0.0};  // unit vector within the picture, outward across the line
};

/// A piece of the line that some ring draws on a picture: both ends lie on one ring, nobody says
/// which.
struct RingThread {
  StemVector from, to;
  std::size_t face = 0;
  StemVector across{1.0, 0.0, 0.0};  // unit vector within the picture, across the line
};

/// What is known before anything is looked at: standard deviations.
struct SolidPrior {
  double pith = 1e3;  // in the unit of the pictures, about where it starts
  double lean = 0.04;
  double taper = 0.04;
  std::vector<double> ripples{};  // of each height
  double together = 1.0;          // neighbours that scatter as one: how little many are worth
};

/// How the places of one picture lie about their rings.
struct FaceScatter {
  double scatter = 0.0;  // across the line, robust standard deviation, in the unit of the pictures
  double effect = 1.0;   // how many neighbours scatter as one
  int sightings = 0;
};

/// The sightings as linear equations at the end of a descent: sum of weight (offset + row state)^2.
struct SolidEquations {
  Eigen::MatrixXd normal;           // sum of weight row row^T
  Eigen::VectorXd right;            // sum of weight offset row
  double squares = 0.0;             // sum of weight offset^2
  double count = 0.0;               // of sightings, outliers counted as what they weigh
  Eigen::VectorXd mean, precision;  // of the prior; that of the ripples as it was used
};

struct SolidFit {
  GrowthSolid solid;
  std::vector<FaceScatter> faces;
  SolidEquations equations;
};

/// The growth that explains the sightings best, by Gauss-Newton with a Cauchy loss.
///
/// start    the prior means; radii are known to half the width of a ring
/// noise    least scatter, in the unit of the pictures
/// threads  how rings bend, where it is not known which they are
SolidFit fitted_solid(const std::vector<RingSighting>& sightings, const GrowthSolid& start,
                      const SolidPrior& prior, std::size_t faces, double noise,
                      const std::vector<RingThread>& threads = {});

}  // namespace hada
