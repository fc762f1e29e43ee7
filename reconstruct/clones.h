#pragma once

/// Marks a function to be compiled for several processors; the one at hand is chosen when the
/// program starts, so that one binary runs everywhere and is as fast as the machine allows.
///
/// GCC alone: under Clang 14 a function whose first declaration lacks the attribute is one version
/// only, that of the first processor listed, and dies elsewhere. There it is compiled once, for
/// the oldest processor; the bytes are the same, as no operation is contracted or reordered.
#if defined(__GNUC__) && !defined(__clang__)
#define HADA_CLONES_AVX2 [[gnu::target_clones("avx2", "default")]]
#define HADA_CLONES_AVX512 [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define HADA_CLONES_AVX2
#define HADA_CLONES_AVX512
#endif
