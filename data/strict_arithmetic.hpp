#pragma once

// Where roundings are undone by sums and products that an optimiser may take for nothing, and where nan is
// looked for, this is included: it refuses what would let it. GCC says so of each option, clang of
// -ffast-math and -ffinite-math-only alone.

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error nipref needs arithmetic as it is written: no -ffast-math, -Ofast, -fassociative-math, -ffinite-math-only
#endif
