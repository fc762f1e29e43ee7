#pragma once

#include <concepts>
#include <variant>

#include "core/extent.h"
#include "core/random.h"
#include "core/surface.h"
#include "synth/forged.h"
#include "synth/knit.h"
#include "synth/wood.h"
#include "synth/wrinkle.h"

namespace hada {

/// Every material that hada knows: the variant is the registry.
using Material = std::variant<Wrinkle<>, Wood<>, Forged<>, Knit<>>;

/// A material of which only the power spectrum is a fact; the phases are luck. `spectrum_of` is its
/// `psd` made ready for many frequencies.
template <class M>
concept Spectral = requires(const M& material, double frequency) {
  { psd(material, frequency, frequency) } -> std::convertible_to<double>;
  { spectrum_of(material)(frequency, frequency) } -> std::convertible_to<double>;
};

/// A material whose making is its own: a solid that is cut, a billet that is folded.
template <class M>
concept Grown = requires(const M& material, const Extent& extent, Seed seed) {
  { surface_of(material, extent, seed) } -> std::same_as<Surface>;
};

}  // namespace hada
