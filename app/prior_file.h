#pragma once

#include <filesystem>
#include <memory_resource>
#include <optional>
#include <string>

#include "core/bounding_box.h"
#include "core/extent.h"
#include "core/surface.h"
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
/// height map, shows what all of the pictures show: where it is finer, pixels are means of its own,
/// where it is coarser, they lie between.
///
/// cutoff   absent: a quarter of the shorter side of the pictures
/// where    the heights lie; null: on the heap
/// throws   Error as `read_surface` does; or if the file holds no height, none of `part`, is of
///          another shape or unit, or the cutoff is below four pixels
PriorHeights read_prior(const PriorArguments& arguments, const Extent& frame, const PixelBox& part,
                        std::pmr::memory_resource* where = nullptr);

/// A line for a person: from where the long waves of the surface are.
std::string told_of_prior(const PriorArguments& arguments, const Surface& surface);

}  // namespace hada
