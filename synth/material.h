#pragma once

#include <concepts>
#include <variant>

#include "synth/wrinkle.h"

namespace hada {

/// Every material that hada knows: the variant is the registry.
using Material = std::variant<Wrinkle<>>;

/// A material of which only the power spectrum is a fact; the phases are luck.
template <class M>
concept Spectral = requires(const M& material, double frequency) {
  { psd(material, frequency, frequency) } -> std::convertible_to<double>;
};

}  // namespace hada
