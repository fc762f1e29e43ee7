#pragma once

#include <optional>
#include <vector>

#include "core/surface.h"
#include "fit/dark_discs.h"
#include "fit/end_grain.h"
#include "fit/face_grain.h"

namespace hada {

/// Where in a ring vessels lie.
enum class Porosity {
  diffuse,  // anywhere
  ring,     // along the boundary that a ring begins at
  both,     // more of them there than elsewhere
};

/// The vessels of an end grain as discs with a place and a radius. Lengths in the unit of the
/// picture.
struct Vessels {
  Porosity porosity = Porosity::diffuse;
  double probability = 0.0;  // of that, against the other two (BIC)
  Known density;             // of those anywhere, for each unit of area
  Known radius;              // their mean radius
  double radius_sd = 0.0;
  Known ring_density;  // of those along boundaries, for each unit of their length
  Known ring_radius;
  Known shade;              // brightness of a vessel beside that of the wood around it
  std::vector<Disc> discs;  // in px: those that count
};

/// The vessels that the picture resolves; nothing where it shows none, or where they are smaller
/// than 4 px.
///
/// What is darker than the wood at the same effective radius nearby is taken apart into discs.
/// Those whose centre lies in the picture clear of its border are counted; porosity is told by how
/// they lie between ring boundaries. Sigma of densities is that of independent places.
///
/// Source: Illian et al., Statistical Analysis and Modelling of Spatial Point Patterns (2008),
/// section 4.2 (minus sampling); Schwarz, Annals of Statistics 6 (1978).
std::optional<Vessels> vessels_of(const Surface& surface, const EndGrain& grain);

}  // namespace hada
