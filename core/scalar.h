#pragma once

namespace hada {

/// The plain number inside a scalar: itself, or the value part of a dual number (`ceres::Jet`).
inline double value_of(double x) {
  return x;
}

template <class Jet>
requires requires(const Jet& jet) {
  jet.a;
}
double value_of(const Jet& jet) {
  return jet.a;
}

}  // namespace hada
