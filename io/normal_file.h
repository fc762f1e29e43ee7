#pragma once

#include <filesystem>
#include <functional>
#include <memory_resource>

#include <Eigen/Core>

#include "core/surface.h"
#include "io/image_file.h"

namespace hada {

/// A normal map of another program, and which of its pixels hold a normal.
struct NormalFile {
  NormalMap normals;  // unit length, z > 0; (0, 0, 1) outside the mask
  Mask mask;          // vectors between 0.5 and 1.5 long that do not look away from the camera
  double share_away = 0.0;        // of the vectors so long: those that do look away
  double share_off_length = 0.0;  // of the normals: shorter than 0.9 or longer than 1.1
};

/// Three channels x, y, z: floats as they are, integers of 8 or 16 bits as (value + 1) / 2.
///
/// memory  where both maps lie, given the size of the picture; absent: on the heap
/// y_down  the file's y points down the rows, as in DirectX; else up, as in OpenGL
/// A normal up to 6 degrees beyond the outline (z > -0.1) is turned back to z = 0.001.
///
/// throws  Error naming the file if `read_image` does, if it has fewer than three channels, if
///         hardly any pixel holds a unit vector, or if its floats are coded as integers would be
NormalFile read_normals(
    const std::filesystem::path& path, bool y_down,
    const std::function<std::pmr::memory_resource*(const PictureShape&)>& memory = {});

/// A picture of one plane, or the mean of three, that belongs to a map of the size of `size`, in
/// the memory of that.
/// throws  Error naming the file if `read_image` does, or if it is of another size
Grid<float> read_plane(const std::filesystem::path& path, const Mask& size);

/// The 3 x 3 matrix of a pin-hole camera as nine numbers in a text file, in pixels: fx 0 cx, 0 fy
/// cy, 0 0 1, the centre of the first pixel at (0, 0).
///
/// throws  Error naming the file and what is wrong
Eigen::Matrix3d read_intrinsics(const std::filesystem::path& path);

}  // namespace hada
