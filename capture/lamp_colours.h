#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "capture/calibrate.h"
#include "capture/load.h"

namespace hada {

/// The colour of each lamp: the strength of each channel over that in grey. Only how they differ
/// from lamp to lamp is meant: a colour that all share passes for one of the surface.
///
/// They are read off the matte sphere that sees the most lamps. Without one everything in the frame
/// tells, whatever its own colour: the ratio of two channels at a pixel is that of the lamp times
/// that of the surface there, so that over the lamps' mean only the lamps are left.
///
/// linear    the photographs, with linear values
/// readings  the spheres, each read by itself
/// returns   one for each picture; all 1 where there is one channel, or nothing that tells
/// throws    Error if the matte sphere shows that a lamp lacks a colour altogether
std::vector<Eigen::Vector3d> lamp_colours(const Photographs& linear,
                                          const std::vector<SphereReading>& readings);

/// The same, as the pixels tell that `counts` holds: those that are lit and not saturated in every
/// picture. Nothing if there is one channel, or fewer than 100 of them are bright enough: 2 % at
/// least of the brightest value of a picture, in every channel.
std::optional<std::vector<Eigen::Vector3d>> lamp_colours(const std::vector<Image>& images,
                                                         const Mask& counts);

/// What the channels weigh in a grey value from which the colour of the lamp is divided out.
std::array<float, 3> grey_weight(const Eigen::Vector3d& lamp_colour);

}  // namespace hada
