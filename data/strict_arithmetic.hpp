#pragma once

// This header is included by code that recovers rounding errors by sums and products that an optimiser might simplify
// to 0, and by code that tests for NaN. It refuses to compile with options that permit this. GCC announces each such
// option by a macro, clang only -ffast-math and -ffinite-math-only.

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error nipref needs arithmetic as it is written: no -ffast-math, -Ofast, -fassociative-math, -ffinite-math-only
#endif
