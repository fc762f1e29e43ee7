#pragma once

#include <cstdint>

/// The inner loops that turn slopes into the right-hand side of the equations of height; compiled
/// for several instruction sets as those of `row_kernels` are.
namespace hada::rise_kernels {

/// From pairs (dz/dx, dz/dy), y up: the rise from a pixel to the one on its right, or below it,
/// rounded as by `row_kernels::relax`; 0 unless both are in the mask.
void rise_across(int n, const float* slopes, const std::uint8_t* mask, float magic,
                 float* __restrict rise);
void rise_down(int n, const float* slopes, const float* slopes_below, const std::uint8_t* mask,
               const std::uint8_t* mask_below, float magic, float* __restrict rise);
/// out = across on the left - across + above - below: what the rises ask of a pixel.
void balance(int n, const float* across, const float* above, const float* below,
             float* __restrict out);

}  // namespace hada::rise_kernels
