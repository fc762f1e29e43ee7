#pragma once

#include <array>
#include <string_view>

#include "core/grid.h"

namespace hada {

/// Areal roughness of a height map; the names are those of ISO 25178-2.
struct Roughness {
  double Sa = 0.0, Sq = 0.0, Sp = 0.0, Sv = 0.0, Sz = 0.0;
  double Ssk = 0.0, Sku = 0.0;
  double Sdq = 0.0, Sdr = 0.0;
  double Sal = 0.0, Str = 0.0, Std = 0.0;
  double Spd = 0.0;
};

/// What a number of `Roughness` is called, counted in and means.
struct RoughnessField {
  std::string_view name;
  double Roughness::*value;
  std::string_view unit;  // "unit" is that of the height, "per unit^2" an area density
  std::string_view meaning;
};

inline constexpr std::array roughness_fields{
    RoughnessField{"Sa", &Roughness::Sa, "unit", "mean absolute height"},
    RoughnessField{"Sq", &Roughness::Sq, "unit", "root mean square height"},
    RoughnessField{"Sp", &Roughness::Sp, "unit", "highest peak"},
    RoughnessField{"Sv", &Roughness::Sv, "unit", "deepest valley"},
    RoughnessField{"Sz", &Roughness::Sz, "unit", "Sp + Sv"},
    RoughnessField{"Ssk", &Roughness::Ssk, "", "skewness"},
    RoughnessField{"Sku", &Roughness::Sku, "", "kurtosis, 3 for a Gaussian surface"},
    RoughnessField{"Sdq", &Roughness::Sdq, "", "root mean square slope"},
    RoughnessField{"Sdr", &Roughness::Sdr, "", "developed over projected area, minus 1"},
    RoughnessField{"Sal", &Roughness::Sal, "unit", "shortest lag of an autocorrelation of 0.2"},
    RoughnessField{"Str", &Roughness::Str, "", "Sal over the longest such lag"},
    RoughnessField{"Std", &Roughness::Std, "rad", "lay, counter-clockwise from +x, [0, pi)"},
    RoughnessField{"Spd", &Roughness::Spd, "per unit^2", "hills that rise 5 % of Sz or more"},
};

/// A roughness and the standard error of each of its numbers.
struct RoughnessEstimate {
  Roughness value;
  Roughness sigma;
};

/// The roughness of `height` inside `mask`, about its mean.
///
/// height, pitch  in one unit
/// returns  the sigma of sums (Sa, Sq, Ssk, Sku, Sdq, Sdr, Std, Sal, Str) by leaving out one of 4 x
/// 4
///          blocks at a time; that of extremes (Sp, Sv, Sz) by the scatter of the extremes of the
///          blocks, which the largest of many shares (Gumbel); that of a count, its square root. A
///          waviness as long as a block is under-estimated.
/// throws   Error if fewer than 64 pixels are in the mask
///
/// Source: Busing, Meijer, van der Leeden, Statistics and Computing 9 (1999), eq. 8: the jackknife
/// for blocks of unequal size.
RoughnessEstimate roughness_estimate(const Grid<float>& height, const Mask& mask, double pitch);

/// The same without standard errors.
Roughness roughness(const Grid<float>& height, const Mask& mask, double pitch);

}  // namespace hada
