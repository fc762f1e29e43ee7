#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "synth/forged.h"

namespace hada {

/// How a picture shows the grain: between the places of the block and the pixels of the picture.
template <class T = double>
struct ForgedView {
  T scale{1.0};         // pixels for a place of the block, down the picture
  T aspect{1.0};        // the same along the rows, over `scale`
  T rotation_rad{0.0};  // of the rows of the block, counter-clockwise
  T blur_px{0.0};       // standard deviation of a Gaussian
  T variance{1.0};      // of the grey values before the blur, over that of the numbers of the block
  T floor{0.0};         // power spectral density of white noise, per cycles^2 / px^2
};

/// What all folds leave of the power at `f` cycles per place along the axis that `cut` stretches.
///
/// A step after which the axis is stretched a more times acts at 2^a f. Doubling a place is worth
/// cos^2(pi f), the mean of three ((1 + 2 cos(2 pi f)) / 3)^2; reflections leave white noise white.
template <class T>
T axis_gain(const std::string& sequence, char cut, HammerKernel kernel, const T& f) {
  using std::cos;
  T gain{1.0}, c = cos(2.0 * std::numbers::pi * f);
  for (auto fold = sequence.rbegin(); fold != sequence.rend(); ++fold) {
    const T mean = (1.0 + 2.0 * c) / 3.0;
    if (*fold == cut || kernel == HammerKernel::both) gain *= mean * mean;
    if (*fold != cut) continue;
    gain *= 0.5 * (1.0 + c);
    c = 2.0 * c * c - 1.0;  // of twice the frequency
  }
  return gain;
}

/// The power spectral density of the grain of an endless block, per (cycle / place)^2.
///
/// Exact for the mean over all places of a block, which repeats its statistics with the period
/// 2^(number of cuts): the doubled places are part of it, and so is all that lies beyond the
/// Nyquist frequency of the coarser block. Near the rim, where nothing lies outside, the grain
/// fades.
template <class T>
T psd(const std::string& sequence, HammerKernel kernel, const T& fx, const T& fy) {
  return axis_gain(sequence, 'C', kernel, fx) * axis_gain(sequence, 'R', kernel, fy);
}

/// The power spectral density of a picture of the grain at (fx, fy) in cycles per px, in px^2.
template <class T>
T psd(const Forged<>& forged, const ForgedView<T>& view, double fx, double fy) {
  using std::cos;
  using std::exp;
  using std::sin;
  const T c = cos(view.rotation_rad), s = sin(view.rotation_rad);
  const T down = view.scale, along = view.scale * view.aspect;
  const T u = along * (c * fx + s * fy), v = down * (c * fy - s * fx);
  constexpr double pi = std::numbers::pi;
  const T blur = exp(-4.0 * pi * pi * (fx * fx + fy * fy) * view.blur_px * view.blur_px);
  return view.variance * down * along * blur *
             psd(forged.sequence, hammer_kernel(forged.kernel), u, v) +
         view.floor;
}

}  // namespace hada
