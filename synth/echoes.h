#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "synth/woven_noise.h"

namespace hada {

/// White noise heard again after every whole number of steps, fainter each time.
struct Echoes {
  Step<> step;
  std::vector<double>
      loudness;  // after 0, 1, ... steps, forwards and back; to a hundred thousandth
};

/// So loud that at n steps the sum of all echoes resembles itself by exp(-n^2 / (2 repeats^2)): the
/// coefficients of the series of the root of the spectrum's comb.
Echoes echoes_of(const Step<>& step, double repeats);

/// No echoes: a step across `step`, as the kernel sees it, that nothing comes back after.
Echoes none_across(const Step<>& step, const WrinkleComponent<>& kernel);

/// Nodes for noise that comes back two ways, so that each step is a whole number of them.
///
/// Echoes are then added up at the nodes, whose number does not grow with their count, and every
/// place feels each node once. The nodes lie as close as those of noise that does not come back:
/// 1.5 standard deviations of the kernel, across the rows of nodes.
class EchoLattice {
 public:
  /// returns  nothing if the two steps are nearly one direction, or if a map of `pitch` shows so
  ///          little of the kernel that there would be more than 16 nodes to a pixel
  static std::optional<EchoLattice> find(const WrinkleComponent<>& kernel, Echoes one, Echoes other,
                                         double pitch);

  /// Adds noise of the kernel's amplitude, were it not for the echoes, to a window around `middle`.
  /// throws  Error if there are more than 3e8 nodes in reach of the window and of its echoes
  void add_to(Grid<float>& field, const Extent& window, const std::array<double, 2>& middle,
              std::uint64_t key) const;

 private:
  /// Those that a window feels, from a = first_a and b = first_b on.
  struct Nodes {
    std::int64_t first_a, first_b;
    Grid<float> values;  // (a, b)
  };

  EchoLattice(const WrinkleComponent<>& kernel, Echoes one, Echoes other)
      : kernel_(kernel), one_(std::move(one)), other_(std::move(other)) {}

  void divide(int one, int other);  // each step into so many
  double least_frequency() const;
  double reach_a() const;  // nodes, beyond which the kernel is not felt
  double reach_b() const;
  std::array<double, 2> node_at(double x, double y) const;
  Nodes nodes_near(const Extent& window, const std::array<double, 2>& middle,
                   std::uint64_t key) const;
  double felt_at(const Nodes& nodes, const std::array<double, 2>& at) const;

  WrinkleComponent<> kernel_;
  Echoes one_, other_;
  int per_one_ = 1, per_other_ = 1;        // nodes to a step
  Step<> a_{}, b_{};                       // from node to node
  double aa_ = 0.0, ab_ = 0.0, bb_ = 0.0;  // the kernel is exp(-(aa a^2 + 2 ab a b + bb b^2) / 2)
  double falling_ = 0.0;                   // exp(-bb)
};

}  // namespace hada
