#pragma once

#include <memory>

#include "mechanics/shell_net.h"

namespace hada {

/// Newton's steps of a shell, as `KnitNewton` has them for a grid: GMRES applies `force_changes`,
/// preconditioned by the factors of the symmetric net whose yarns are 1 + 3 c times as stiff along.
class ShellNewton {
 public:
  ShellNewton();
  ~ShellNewton();

  /// As `KnitNewton::step`.
  Places step(const ShellNet& net, const ShellSprings& springs, const KnitFrames& frames,
              const Places& load, double tolerance, double drag = 0.0);

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace hada
