#pragma once

#include <array>
#include <vector>

#include "core/random.h"
#include "synth/wood.h"

namespace hada {

/// A stem ready to be asked what is where. Coordinates are those of `Wood`.
class WoodSolid {
 public:
  WoodSolid(const Wood<>& wood, Seed seed, Ripples ripples = {});

  /// What belongs to a place: how far out and when it grew, and where its fibre crosses z = 0.
  struct Place {
    double r, theta;              // from the pith at its height
    double rho;                   // effective radius
    double year;                  // time of growth t, in rings from the pith; whole at a boundary
    double angle;                 // of the fibre at z = 0 around the pith, radians, unwrapped
    double section_x, section_y;  // the same in the section with round rings
  };
  Place place_at(const StemVector& at) const;

  /// The same of a place in the section, where fibres cross z = 0 and rings are round.
  Place place_in_section(double rho, double angle) const;

  /// How far a fibre has run along its ring from z = 0 to z, mm: the integral of its gradient.
  double arc_at(double rho, double z) const { return arc_of(year_at(rho), z); }

  /// The fibre gradient there: slope of the fibre on its ring.
  double gradient_at(const Place& place, double z) const;

  /// The direction of the fibre, unit length, up the stem.
  StemVector fibre_at(const StemVector& at) const;

  /// Linear albedo, edges softened over `soft_mm`.
  std::array<float, 3> colour_at(const Place& place, double soft_mm) const;

 private:
  double growth_at(double r, double dx, double dy, double theta) const;
  double year_at(double rho) const;
  double radius_of(double year) const;
  double fluctuation_at(double year, double z) const;
  double arc_of(double year, double z) const;
  double turn_at(double r, double year, double z) const;
  double shade_at(const Place& place, double soft_mm) const;
  double scattered_vessels(const Place& place, double soft_mm) const;
  double boundary_vessels(const Place& place, double soft_mm) const;

  Wood<> wood_;
  Seed wobble_, fluctuation_, fibres_, scattered_, boundary_;  // a random field each
  Ripples ripples_;
  std::vector<double> turn_at_zero_;  // of the fluctuation, by the sixteenth of a year
  double usual_width_ = 1.0;          // of a ring, mm
  bool whole_orders_ = true;          // of all lobes
  double wave_start_ = 1.0;           // cosine of the wave at z = 0
  double inner_years_ = 0.0;          // rings inside the first that is listed
  double vessel_cell_ = 1.0;          // mm
};

}  // namespace hada
