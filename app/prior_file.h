#pragma once

#include <filesystem>
#include <optional>

#include "core/bounding_box.h"
#include "core/extent.h"
#include "reconstruct/prior_heights.h"

namespace hada {

/// Heights that a person knows from elsewhere, and what to take from them.
struct PriorArguments {
  std::optional<std::filesystem::path> file;
  std::optional<double> cutoff;  // wavelength, in the unit of the surface
};

/// The heights of `arguments.file` on the pixels of `part` of the pictures, `frame`.
///
/// A surface of the pitch of the pictures lies where its `offset_px` says; any other surface, or a
/// height map, shows what all of the pictures show, and is stretched to their size.
///
/// cutoff   absent: a quarter of the shorter side of `part`
/// throws   Error as `read_surface` does; or if the file holds no height, is of another shape or
///          unit, or the cutoff is below four pixels
PriorHeights read_prior(const PriorArguments& arguments, const Extent& frame, const PixelBox& part);

}  // namespace hada
