#pragma once

#include "core/grid.h"
#include "synth/wrinkle.h"

/// Ridges: what a sheet of paper has beyond its spectrum. A Gaussian field is as often up as down
/// and knows no creases; two monotone layers over it change that.
namespace hada {

/// The transport of a normal number to one of mean 0 and variance 1 with another histogram.
///
/// T(z) = (sinh(e^tail asinh z + skew) - mean) / deviation: increasing in z, z itself for zeros.
/// Source: Jones and Pewsey, Sinh-arcsinh distributions, Biometrika 96 (2009); of a field, a
/// translation process (Grigoriu, Journal of Engineering Mechanics 110, 1984).
class HeightTransport {
 public:
  HeightTransport(double skew, double tail);

  double operator()(double z) const;

 private:
  double skew_, stretch_, mean_ = 0.0, deviation_ = 1.0;
};

/// `height` with sharper crests (radius above 0) or sharper valleys (below 0), in place.
///
/// min over y of height(y) + |x - y|^2 / (2 radius): where dH/dt = -|grad H|^2 / 2 leads in the
/// time `radius`. Valleys keep a curvature of 1 / radius at most, crests are driven together to
/// edges.
///
/// radius_px  in pixels^2 per unit of height
/// tiles      whether the map goes on at its other side
///
/// Source: Hopf-Lax formula (Evans, Partial Differential Equations, 3.3); by lower envelopes of
/// parabolas, line after line (Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012).
void sharpen(Grid<float>& height, double radius_px, bool tiles);

/// Whether anything lies over the Gaussian field.
bool has_ridges(const Wrinkle<>& wrinkle);

/// The radius that `sharpness` stands for, in mm (length^2 over height).
///
/// sinh(sharpness) / 8 over the root mean square of the curvature of the noise functions: in
/// proportion while sharpness is small, then e times as much for each step of 1, which moves the
/// histogram of curvature by as much again. Where it is 1 over a curvature (sharpness 2.8 for the
/// mean one), crests of that curvature become edges.
double sharpening_radius(const Wrinkle<>& wrinkle);

/// How far, in pixels, the place may lie whose height decides that of another.
int felt_by_ridges(const Wrinkle<>& wrinkle, double pitch);

/// The noise functions of `wrinkle`, without its floor, once its layers lie over them.
///
/// field  a realisation of the Gaussian noise functions, in mm
Grid<float> with_layers(Grid<float> field, const Wrinkle<>& wrinkle, double pitch, bool tiles);

/// The same for a field that tiles, with its power where it was: waves that gained by the layers
/// are weakened and others strengthened, so that the phases alone tell of ridges.
Grid<float> with_ridges(const Grid<float>& field, const Wrinkle<>& wrinkle, double pitch);

}  // namespace hada
