#pragma once

#include <vector>

#include "measure/leakage.h"
#include "measure/spectrum.h"

namespace hada {

/// Neighbouring ordinates of a spectrum, seen as one.
struct Cell {
  double fx = 0.0;  // mean frequency, cycles per unit
  double fy = 0.0;
  double power = 0.0;    // mean, unit^4
  double leakage = 0.0;  // power from afar, beyond what a flat spectrum would send, unit^4
  double noise = 0.0;    // power that is known to be noise of the measurement, unit^4
  int count = 0;         // ordinates; f and -f count once
  /// What tapering the map and averaging over the cell do to an autocovariance: both multiply it
  /// by exp(-(xx dx^2 + 2 xy dx dy + yy dy^2)), 1/unit^2.
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double correction = 1.0;          // of the model's power, where that window is not exact
  std::vector<int> ordinates = {};  // row * (cols / 2 + 1) + col of each, 0 <= col <= cols / 2
};

struct CellOptions {
  double empty_steps = 0.5;    // frequency steps around 0 that levelling has emptied
  double reach = 1.0;          // share of the Nyquist frequency at which the cells end
  double inner_bins = 16.0;    // up to this many frequency steps from 0 an ordinate stays alone
  double growth = 0.06;        // size of a cell further out, as a share of its distance from 0
  int patch = 0;               // side of a cell further out, ordinates; 0: as `growth` says
  double most_leakage = 0.15;  // share of a cell's power; a cell with more is left out
  double faintest = 1e-10;     // share of the highest power; a cell with less is left out
};

/// The half plane of a spectrum, cut into cells that grow with their distance from frequency 0, or
/// into equal patches.
///
/// Left out are the frequencies around 0, those beyond the reach, and those that hold
/// little but leakage or rounding. The mean of S over a cell is, to third order in its size, the
/// transform of an autocovariance narrowed by twice pi^2 times the scatter of its frequencies: that
/// is where `xx`, `xy` and `yy` come from.
std::vector<Cell> cells_of(const Spectrum& spectrum, const Leakage& leakage,
                           const CellOptions& options = {});

}  // namespace hada
