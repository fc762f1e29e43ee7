#pragma once

namespace hada {

/// Gloss of made boards under nine lights: worst relative errors of k_s and n, and the largest mean
/// error of the dive of the fibres.
struct FigureScore {
  double specular = 0.0, sharpness = 0.0, dive_deg = 0.0;
};

FigureScore study_figures(int seeds);

}  // namespace hada
