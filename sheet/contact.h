#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sheet/plate.h"
#include "sheet/sheet.h"

namespace hada {

/// Watches faces while they move, so that none passes through another: not across it, not from one
/// side of a face that it lies on to the other, and not through it face to face.
class ContactWatch {
 public:
  /// order      of the faces that lie on each other at the start
  /// moving     if given, these turn as one and all others stay: only pairs of both kinds can meet
  /// tolerance  a length; what passes by less is rounding
  ContactWatch(const Sheet& sheet, const std::vector<FaceOrder>& order,
               const std::vector<bool>& moving, double tolerance);

  /// Two faces that would pass through each other on the way from the places that were accepted
  /// last to these. Ways are short: a few degrees of a turn.
  std::optional<std::array<int, 2>> meets(const std::vector<Eigen::Vector3d>& places) const;
  void accept(const std::vector<Eigen::Vector3d>& places);

 private:
  struct Pair {
    int face, other;
    bool crosses = false;  // from the start, before anything moved
    bool marked = false;   // they lay on each other, at these marks
    Eigen::Vector2d mark = {0.0, 0.0}, other_mark = {0.0, 0.0};
    int side = 0;  // of `other` on which `face` is, 1 the printed one; 0: in its plane
  };
  double offset(const Pair& pair, const std::vector<Plate>& plates) const;
  int side_of(double offset) const;
  bool passes(const Pair& pair, const std::vector<Eigen::Vector3d>& places, double offset) const;

  std::vector<std::vector<int>> corners_;  // of the faces
  double size_, tolerance_;
  std::vector<Pair> pairs_;
  std::vector<Eigen::Vector3d> accepted_;
};

/// How far faces turned about an axis, as one.
struct Reached {
  double share = 1.0;                                // of the angle
  std::optional<std::array<int, 2>> met = {};        // the faces that met, if it ended early
  std::vector<Eigen::Vector3d> shortly_before = {};  // where vertices were not long before the end
};

/// Turns faces of a sheet about an axis, until the angle is reached or they meet one that stays.
///
/// moving  all others stay
/// watch   that has seen them where they are, and goes with them
/// along   unit length; positive angles turn about it by the right hand
Reached turn_faces(Sheet& sheet, ContactWatch& watch, const std::vector<bool>& moving,
                   const Eigen::Vector3d& from, const Eigen::Vector3d& along, double angle);

/// The same with a watch of its own.
Reached turn_faces(Sheet& sheet, const std::vector<FaceOrder>& order,
                   const std::vector<bool>& moving, const Eigen::Vector3d& from,
                   const Eigen::Vector3d& along, double angle);

}  // namespace hada
