#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/sphere.h"

namespace hada {

/// A box in a picture, a hint of where something is: u0, v0, u1, v1 in px, v down.
using BoxPx = std::array<double, 4>;

/// A folder of photographs and what its owner said of it (`capture.json`, `"hada": "capture/1"`).
struct CaptureFile {
  struct Picture {
    std::filesystem::path file;                // absolute or relative to the working directory
    std::string name;                          // as the manifest or the folder names it
    std::optional<Eigen::Vector3d> direction;  // "light", normalised
    std::optional<Eigen::Vector3d> strength;   // a number stands for three equal ones
  };
  struct SphereHint {
    std::optional<SphereKind> kind;  // absent: auto
    std::optional<BoxPx> box;
    std::optional<double> diameter_mm;
  };
  struct CameraHint {
    bool perspective = false;
    std::optional<double> focal_px;
    std::optional<double> distance_mm;
  };

  std::filesystem::path folder;
  std::vector<Picture> pictures;
  std::string encoding = "auto";  // auto, linear or srgb
  std::optional<double> pitch_mm;
  std::vector<SphereHint> spheres;
  std::optional<BoxPx> sample_box;
  std::optional<std::filesystem::path> mask, ambient, flat, dark;
  std::optional<CameraHint> camera;
  std::string lamps = "auto";  // auto, distant or near
  /// k of what the lens leaves of the light at r: 1 + k1 r^2 + k2 r^4 + k3 r^6, r the distance from
  /// the middle of the picture over half its diagonal.
  std::array<double, 3> vignetting{};
  std::vector<std::string> left_out;  // "notes.txt (not an image)": what was not used, and why
};

/// What is in the folder. Without a manifest: its images in natural order of their names (a2 before
/// a10), a file with "mask" in its name is the mask, likewise "ambient", "flat", "dark"; whatever
/// does not belong is left out by name.
///
/// throws  Error for a missing folder, a folder without images, and any flaw of the manifest
CaptureFile read_capture_file(const std::filesystem::path& folder);

/// The text of a manifest; file names are written relative to `folder`.
std::string capture_text(const CaptureFile& capture);

}  // namespace hada
