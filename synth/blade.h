#pragma once

#include "core/grid.h"
#include "core/mesh.h"
#include "core/random.h"

namespace hada {

/// The shape of a sword blade, in the words of its makers; the defaults are those of a katana.
struct BladeShape {
  double length_mm = 700.0;
  double width_mm = 31.0;      // from edge to back, at the base
  double tip_width_mm = 21.0;  // where the point begins
  double point_mm = 35.0;      // length of the point (kissaki)
  double thickness_mm = 7.0;   // at the base; it tapers with the width
  double curvature_mm = 16.0;  // how far the back bends off the chord (sori)
  double ridge = 0.6;          // place of the ridge between edge (0) and back (1)
  int segments = 160;          // along the blade
};

/// A closed mesh of the blade: base at x = 0, point at +x, edge below, back above, sides +-z.
///
/// uv  each side carries the whole picture, u from base to point, v from edge to back; with the
///     default shape that is the paper's picture of 1:8
TriangleMesh blade_mesh(const BladeShape& shape);

/// Where the edge is hardened, seen as a whiter and rougher band along it (hamon).
struct HamonShape {
  double height = 0.3;  // of the band, as a share of the blade's width; 0: none
  double wave = 0.08;   // height of its waves, likewise
  double waves = 24.0;  // along the blade
  double mist = 0.03;   // width of its border (nioi), likewise
};

/// 1 in the hardened edge, 0 above, between them over the border; row 0 at the back of the blade.
///
/// The waves are a sine whose phase and height wander, keyed by `seed`.
Grid<float> hamon_mask(int rows, int cols, const HamonShape& shape, Seed seed);

/// How the steel was worked after its last fold, so that its grain runs in waves (ayasugi).
struct AyasugiShape {
  double wavelength = 0.0;  // places along the rows; 0: none
  double amplitude = 40.0;  // places that the grain moves across the rows
  double depth = 0.0;       // of the grooves: how much of the amplitude is filed off their crests
  bool twisted = false;     // the bar was twisted, instead of filed with round grooves
};

/// A block of grain with waves, its size unchanged.
///
/// Filed: round grooves across the blade, hammered flat, leave layers that run as deep as the
/// groove was: row i of the picture shows row i + amplitude cos(2 pi j / wavelength). A depth clips
/// the crests, as a file does that stops short of the ground. Twisted: the layers turn about the
/// axis of the bar, and what its side shows is their sawtooth, rounded by the hammer. Beyond the
/// rim the grain is reflected. Source: Koizumi (1933) as cited in the paper on forged steel grain,
/// section 1; the paper itself has no formula for this grain.
Grid<float> ayasugi(const Grid<float>& grain, const AyasugiShape& shape);

}  // namespace hada
