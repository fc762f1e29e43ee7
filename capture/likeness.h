#pragma once

#include "capture/circle.h"
#include "capture/load.h"
#include "capture/overview.h"

namespace hada {

/// How much the inside of a circle behaves like a matte sphere: 0 if not at all; else the share of
/// its contrast that the shading of a sphere explains in nearly every picture, up to 1.
double matte_likeness(const Photographs& photographs, const Overview& all, const Circle& circle);

/// How much it behaves like a mirror: the share of pictures with one clear, compact highlight, if
/// that wanders from picture to picture; 0 if fewer than 60 % have one.
double chrome_likeness(const Photographs& photographs, const Overview& all, const Circle& circle);

}  // namespace hada
