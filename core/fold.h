#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hada {

/// What happens along an edge of a sheet: the letters of the FOLD format.
enum class Crease : char {
  border = 'B',
  mountain = 'M',
  valley = 'V',
  flat = 'F',        // no fold: a facet edge, or a crease that was opened again
  unassigned = 'U',  // folded, mountain or valley
  cut = 'C',
  join = 'J',
};

/// Whether paper turns over at such an edge once the sheet is folded flat.
inline bool is_folded(Crease crease) {
  return crease == Crease::mountain || crease == Crease::valley || crease == Crease::unassigned;
}

/// Face `face` lies above (+1) or below (-1) face `other`, seen with the normal of `other` up; 0:
/// they do not touch, or nobody knows.
struct FaceOrder {
  int face = 0;
  int other = 0;
  int order = 0;

  bool operator==(const FaceOrder&) const = default;
};

/// One state of a sheet, as a frame of a FOLD file tells it.
///
/// Vertices are in the file's own unit; a flat state has z = 0. Lists that speak of edges or faces
/// are as long as those, or empty where nothing is said.
struct FoldFrame {
  std::string title;
  std::string unit;                  // empty: not said
  std::vector<std::string> classes;  // such as creasePattern, foldedForm
  bool flat = true;                  // all vertices have two coordinates
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 2>> edges;
  std::vector<Crease> assignment;       // of the edges
  std::vector<double> fold_angle_deg;   // of the edges: valleys > 0, mountains < 0, NaN: not said
  std::vector<std::vector<int>> faces;  // vertices, counter-clockwise seen from the printed side
  std::vector<FaceOrder> face_orders;

  /// What an edge does: `unassigned` where the file is silent.
  Crease crease(int edge) const {
    return assignment.empty() ? Crease::unassigned : assignment[std::size_t(edge)];
  }
};

/// A FOLD file: who made it, and its frames, the key frame first.
struct FoldFile {
  std::string creator;
  std::string author;
  std::string title;
  std::vector<FoldFrame> frames;
};

}  // namespace hada
