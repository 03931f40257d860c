#ifndef ARGOS3_CORE_UTILITY_MATH_VECTORIZED_H
#define ARGOS3_CORE_UTILITY_MATH_VECTORIZED_H

#include <argos3/core/utility/datatypes/datatypes.h>

/**
 * Precedes the definition of a function whose time is spent in loops over arrays of numbers: it is
 * compiled for several generations of x86-64 processors, of which the dynamic loader chooses one.
 *
 * Results are equal to the bit on all of them: additions, multiplications, divisions and square
 * roots of vectors round as those of single numbers, and nothing is fused (-ffp-contract=off). A
 * function that the loader chooses is not inlined, so it must do enough work for a call. Only with
 * g++, and not with sanitizers, which do not support the choice.
 */
#if defined(__x86_64__) && defined(__ELF__) && defined(__OPTIMIZE__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ARGOS_VECTORIZED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ARGOS_VECTORIZED
#endif

/**
 * Precedes a loop with a small constant number of iterations, which g++ would unroll before it
 * looks for loops to vectorize.
 */
#if defined(__GNUC__) && !defined(__clang__)
#define ARGOS_VECTOR_LOOP _Pragma("GCC unroll 1")
#else
#define ARGOS_VECTOR_LOOP
#endif

namespace argos {

/** Element i has bit i: loops over lanes gather the numbers of some lanes from these. */
constexpr UInt64 kLaneBits[] = {1U << 0,  1U << 1,  1U << 2,  1U << 3, 1U << 4,  1U << 5,
                                1U << 6,  1U << 7,  1U << 8,  1U << 9, 1U << 10, 1U << 11,
                                1U << 12, 1U << 13, 1U << 14, 1U << 15};

}  // namespace argos

#endif
