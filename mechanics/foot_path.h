#pragma once

#include <optional>

#include "mechanics/body.h"

namespace hada {

/// A plane through a limb, as a place in it and two unit directions; rays from the place leave the
/// limb at its outline.
struct LimbSection {
  Eigen::Vector3d middle, out, across;
};

/// A leg with a foot, as sections through it: level ones down the leg, a fan about a pivot before
/// the instep around the heel, upright ones along the foot, and rays from the middle of the toes.
class FootPath {
 public:
  /// The ankle is where the outline is shortest in the lower 45 % of the body; the foot points to
  /// what lies farthest from it below.
  ///
  /// axis    x, y or z: up the leg, the foot at its low end
  /// top_mm  height where the leg ends; absent: a twentieth of the body below its top
  /// throws  Error if there is no foot below the ankle, or the top is not above it
  FootPath(const Body& body, int axis, std::optional<double> top_mm);

  // Shares run from 0 to 1 down the leg, around the heel, along the foot.
  LimbSection leg(double share) const;
  LimbSection heel(double share) const;
  LimbSection foot(double share) const;
  /// Where the ray of a section leaves the limb; turn 0 is in front, or on the instep.
  MeshPlace place(const LimbSection& section, double turn) const;
  /// Around the toes: share 0 is the end of the foot, 1 the tip.
  MeshPlace toe(double share, double turn) const;

  double leg_mm() const { return top_ - ankle_; }
  double heel_mm() const { return heel_mm_; }  // around it, at the back
  double foot_mm() const { return toes_from_ - foot_from_; }
  double toe_mm() const { return toe_mm_; }      // from the end of the foot to the tip
  double girth_mm() const { return girth_mm_; }  // of the ankle

 private:
  MeshPlace leaves(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const;
  Eigen::Vector3d centred(Eigen::Vector3d middle) const;
  void find_forward();
  void follow_foot();
  void measure();

  const Body& body_;
  int axis_;
  double top_ = 0.0, ankle_ = 0.0;            // heights
  double foot_from_ = 0.0, toes_from_ = 0.0;  // along `forward_`
  double heel_mm_ = 0.0, toe_mm_ = 0.0, girth_mm_ = 0.0, reach_ = 0.0;
  Eigen::Vector3d up_, forward_, side_, pivot_;
  std::vector<Eigen::Vector3d> middles_;  // along the foot, evenly
};

}  // namespace hada
