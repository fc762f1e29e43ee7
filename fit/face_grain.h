#pragma once

#include <functional>
#include <vector>

#include "core/surface.h"
#include "measure/streaks.h"

namespace hada {

/// A number and its standard deviation.
struct Known {
  double value = 0.0;
  double sigma = 0.0;
};

/// How the fibres of a face lean, which is cut along the stem, the stem upright in the picture:
/// slope = gradient + amplitude sin(2 pi s / length + phase), s up the face (a wave) or across it
/// (interlocked grain).
struct FaceGrain {
  enum class Kind { straight, wavy, interlocked };
  Kind kind = Kind::straight;
  Known gradient;        // g1, mean slope to the right for each step up
  Known amplitude;       // of the wave or the interlock; 0 if straight
  Known length;          // of one period, in the unit of the picture
  Known phase;           // at the centre of the picture, radians
  double scatter = 0.0;  // of the parts about that, slope
  int parts = 0;         // of the picture that show streaks
  int asked = 0;         // parts that were looked at
};

/// What the slope of a part is taken for, NaN to leave it out.
using StreakReading = std::function<double(const Streak&)>;

/// reading  the slope as it is seen, if empty
/// throws   Error if there is no albedo, or fewer than 12 parts of the picture show fibres
FaceGrain face_grain(const Surface& surface, const StreakReading& reading = {});

/// Whether the picture shows a face and no end grain: fibres run up it, and its lines run side by
/// side where rings would meet in a pith.
bool looks_like_a_face(const Surface& surface);

}  // namespace hada
