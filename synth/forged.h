#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/extent.h"
#include "core/field.h"
#include "core/grid.h"
#include "core/random.h"
#include "core/surface.h"

namespace hada {

/// Along which axes the moving average of three places acts after a fold.
enum class HammerKernel { both, stretched };

/// The kernel of that name, which is valid.
HammerKernel hammer_kernel(std::string_view name);

bool is_fold_sequence(std::string_view text);
bool is_hammer_kernel(std::string_view text);

/// The grain of forged steel (kitae-hada): a block that is folded and hammered out, again and
/// again.
///
/// Cut C folds left onto right and stretches along the columns, cut R folds top onto bottom and
/// stretches along the rows. Source: the paper on forged steel grain, section 2; equations 2 and 4
/// as restored in docs/methods.md.
template <class T = double>
struct Forged {
  static constexpr std::string_view name = "forged";
  static constexpr std::string_view summary = "grain of folded steel: masame, itame, mokume";

  std::string sequence = "CRCRCR";
  std::string kernel = "both";
  T levels{70.0};
  T step{5.0};
  T etch_mm{0.002};

  static constexpr auto words() {
    using W = Word<Forged>;
    return std::array{
        W{"sequence", &Forged::sequence, is_fold_sequence, "made of 1 to 16 letters C and R",
          "the folds: C across the columns, R across the rows"},
        W{"kernel", &Forged::kernel, is_hammer_kernel, "\"both\" or \"stretched\"",
          "axes along which three places are averaged after a fold"},
    };
  }
  static constexpr auto fields() {
    using F = Field<Forged, T>;
    return std::array{
        F{"levels", &Forged::levels, 1.0, 255.0, Scale::linear, "",
          "grey value of the highest place"},
        F{"step", &Forged::step, 0.0, 255.0, Scale::linear, "",
          "grey values between neighbouring levels; 0: not quantised"},
        F{"etch_mm", &Forged::etch_mm, 0.0, 1.0, Scale::linear, "mm",
          "height that etching leaves between grey values 0 and levels"},
    };
  }
};

/// Size of a block of steel in places; the defaults are those of the paper.
struct BlockSize {
  int rows = 2048;
  int cols = 16384;
};

/// The smallest block no smaller than `size` that can be halved along the axes that are cut.
BlockSize divisible(const BlockSize& size, const std::string& sequence);

/// The block after its first C and its first R, none of them hammered: halves laid onto each other.
///
/// The hammering before the first cut needs not be waited for, because it commutes with a fold: a
/// fold is a reflection, and the moving average does not change under it.
/// block  `divisible` by the sequence
Grid<float> first_cuts(const Grid<float>& block, const std::string& sequence);

/// The block after all folds, hammered out to its old size: equations 2 and 3 for every letter.
///
/// pile  what `first_cuts` returns
Grid<float> hammered(Grid<float> pile, const std::string& sequence, HammerKernel kernel);

/// A block of independent normal numbers of mean 0 and variance 1 after all folds: the height H_N
/// of the paper.
///
/// What the first cuts make of independent numbers are independent numbers of smaller variance. So
/// these are drawn, keyed by their place in the pile; the block before its first cut never exists.
/// size  `divisible` by the sequence
Grid<float> forged_block(const Forged<>& forged, const BlockSize& size, Seed seed);

/// What a picture shows of a block, as it was hammered out, and how far the whole block reaches.
struct ForgedPart {
  Grid<float> height;
  double low = 0.0, high = 0.0;  // of the whole block
};

/// The upper left part of a block of the paper's size, or of a larger one if the picture is.
ForgedPart forged_part(const Forged<>& forged, const BlockSize& size, Seed seed);

/// What etching makes of a part that was forged before, with the same folds.
///
/// returns  as albedo the grey values of equation 5, as a file of 8 bits would store them (the sRGB
///          code is grey / 255); as height the same, etched `etch_mm` deep, zero-mean
Surface surface_of(const Forged<>& forged, ForgedPart part, const Extent& extent);

/// The same, forged and etched: `extent` of the upper left part of a block.
Surface surface_of(const Forged<>& forged, const Extent& extent, Seed seed);

/// Equation 5: grey values step floor((h - min) / (max - min) levels / step) in place of heights;
/// with a step of 0, (h - min) / (max - min) levels.
void quantise(Grid<float>& height, double levels, double step);

/// The same of a part, whose whole has its min at `low` and its max at `high`.
void quantise(ForgedPart& part, double levels, double step);

}  // namespace hada
