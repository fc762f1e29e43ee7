#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "capture/photograph.h"
#include "capture/relief.h"

namespace hada {

/// Where a sheet lies on the fine lattice: that of the picture, each pixel cut into
/// `oversampling` x `oversampling` cells of the sheet's own pitch.
struct SheetPlace {
  int oversampling;
  int row, col;  // of the sheet's first cell on the fine lattice
};

/// The place that `rig` asks for, rounded to the fine lattice.
/// throws  Error if the sheet has no height in mm, its pitch does not divide the picture's, or it
///         does not fit into the picture
SheetPlace place_of(const Surface& sheet, const Rig& rig);

/// What lies under the virtual camera, cell by cell: the sheet, the table at z = 0 that its lowest
/// point touches, and the spheres that rest on it.
///
/// Light falls from one direction at a point, so shadows have sharp edges; a chrome sphere sees the
/// light as a disc, the dark room, and the sheet and table as if they were flat; spheres do not see
/// each other.
class VirtualScene {
 public:
  /// throws  Error as `place_of` does
  VirtualScene(const Surface& sheet, const Rig& rig);

  int oversampling() const { return place_.oversampling; }
  int channels() const { return channels_; }
  /// Whether the cell shows the sheet and nothing else.
  bool shows_sheet(int row, int col) const { return on_sheet_(row, col) && !near_sphere(row, col); }
  /// Adds the values of one cell to sums[light * channels + channel].
  void add_cell(int row, int col, std::span<double> sums) const;

 private:
  struct Spot;
  Eigen::Vector3d cell(int row, int col) const;
  bool near_sphere(int row, int col) const;
  Spot ground(int row, int col) const;
  void add_sphere_cell(int row, int col, std::span<double> sums) const;
  void add_matte(const Spot& spot, double weight, std::span<double> sums) const;
  void add_chrome(const Spot& spot, double weight, std::span<double> sums) const;
  double irradiance(const Spot& spot, const Light& light) const;
  bool hidden_by_spheres(const Spot& spot, const Eigen::Vector3d& to_light) const;

  const Surface& sheet_;
  const Rig& rig_;
  SheetPlace place_;
  Extent fine_;
  int channels_ = 1;
  NormalMap normals_;               // of the sheet
  Eigen::Vector3d mean_albedo_;     // of the sheet
  std::vector<Light> unit_lights_;  // the rig's, with strength 1
  Mask on_sheet_;                   // of the fine lattice
  Relief relief_;                   // of the fine lattice, 0 on the table
};

}  // namespace hada
