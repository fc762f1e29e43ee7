#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/fold.h"

namespace hada {

/// One side of an edge. Sides 2 e and 2 e + 1 belong to edge e and run in opposite directions; each
/// has its face to the left, on the printed side of the flat sheet.
struct HalfEdge {
  int origin = 0;  // vertex where it begins
  int face = -1;   // -1 outside the sheet
  int next = -1;   // along the face, or along the border
};

/// A sheet of paper: where its vertices lie while it is flat and now, its edges and its faces.
struct Sheet {
  std::vector<Eigen::Vector2d> flat;    // counter-clockwise faces
  std::vector<Eigen::Vector3d> folded;  // as many
  std::vector<HalfEdge> halves;         // two for each edge
  std::vector<Crease> creases;          // of the edges
  std::vector<double> fold_angles;      // of the edges, radians: valleys > 0, mountains < 0
  std::vector<int> face_halves;         // one half-edge of each face

  int vertices() const { return int(flat.size()); }
  int edges() const { return int(creases.size()); }
  int faces() const { return int(face_halves.size()); }

  const HalfEdge& half(int h) const { return halves[std::size_t(h)]; }
  int origin(int h) const { return half(h).origin; }
  int target(int h) const { return half(h ^ 1).origin; }
  bool is_border(int edge) const { return half(2 * edge).face < 0 || half(2 * edge + 1).face < 0; }

  /// Half-edges around a face, in order.
  std::vector<int> halves_of(int face) const;
  /// Vertices around a face, in order.
  std::vector<int> corners_of(int face) const;
};

/// A sheet of a flat frame. Where the frame has no faces, they are found between its lines, which
/// are cut where they cross; edges with nothing beyond them become border.
///
/// throws  Error with `where` if the frame is not flat, has no edges, its faces overlap at an edge
///         or have no area, or the sheet falls into parts
Sheet sheet_of(const FoldFrame& frame, const std::string& where);

/// The sheet as a frame: flat, or as it is folded now.
FoldFrame flat_frame(const Sheet& sheet);
FoldFrame folded_frame(const Sheet& sheet);

/// A square with this side, its lower left corner at the origin.
Sheet square_sheet(double side);

}  // namespace hada
