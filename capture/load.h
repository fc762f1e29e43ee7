#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/camera.h"
#include "core/grid.h"
#include "core/image.h"
#include "io/capture_file.h"

namespace hada {

/// The photographs of a folder, before anyone knows their lights.
///
/// Values are those of the files, scaled so that 1 is the largest a file could hold; dark, ambient
/// and flat are taken into account by `linearize`.
struct Photographs {
  CaptureFile file;
  Camera camera;
  std::vector<Image> images;    // all of one size, all with one or all with three planes
  std::vector<Mask> saturated;  // one for each image: 1 where any channel was at its largest value
  Mask mask;                    // as the owner gave it; empty if nobody did
  int bits = 8;                 // the smallest depth among the files
  bool linear = true;           // false: the values carry the sRGB curve
  bool encoding_known = true;   // false: `linear` is an assumption that a matte sphere may correct
  Eigen::Vector3d ambient_light{0.0, 0.0, 0.0};  // what every linear picture shows without a lamp
  std::vector<std::string> remarks;
};

struct LoadOptions {
  std::optional<std::pmr::memory_resource*> memory;  // none: `memory_for_pictures` says
};

/// Reads every picture that `file` names, one after the other: large ones are kept on disk, so that
/// they need not fit into memory together.
///
/// throws  Error for fewer pictures than one, mixed sizes or channel counts, values that are not
///         finite, and pictures that are all black or all white
Photographs load_photographs(const CaptureFile& file, const LoadOptions& options = {});

/// The same photographs with linear values: sRGB curve undone where it was on, dark, ambient and
/// `ambient_light` taken off, the flat field and what the lens leaves of the light divided out.
Photographs linearized(Photographs photographs);

/// Whether the owner said how the lens darkens the corners.
bool has_vignetting(const CaptureFile& file);

/// Whether `linearized` would change no value.
bool is_linearized(const Photographs& photographs);

/// Another set of the same pictures, of which none stays in memory if they are on disk.
Photographs copy_of(const Photographs& photographs);

/// What is known of them, without the pictures themselves.
Photographs without_pictures(const Photographs& photographs);

}  // namespace hada
