// SPDX-License-Identifier: MIT
/// \file
/// What the proofs in binary64 assume of compiler and machine: refused at compile time where the compiler says otherwise, at run time where
/// it cannot know.
#pragma once

#include <cfenv>
#include <cfloat>
#include <limits>
#include <stdexcept>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Touchstone's proofs need IEEE arithmetic: do not compile with -ffast-math or -ffinite-math-only"
#endif
#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "Touchstone's proofs need binary64 operations that round to binary64 (FLT_EVAL_METHOD = 0): on x86, compile with -msse2 -mfpmath=sse"
#endif

namespace touchstone {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

/// Where an engine whose bounds are binary64 numbers is entered. \throws std::runtime_error unless this thread rounds to nearest and keeps
/// subnormal numbers
inline void require_binary64_arithmetic()
{
    if (std::fegetround() != FE_TONEAREST)
        throw std::runtime_error("this thread does not round to nearest: set FE_TONEAREST before asking for certified values");
    volatile double least = std::numeric_limits<double>::min(), subnormal = std::numeric_limits<double>::denorm_min();
    const volatile double half = least / 2, twice = subnormal + subnormal;
    if (half == 0 || twice == 0)
        throw std::runtime_error(
            "this thread flushes subnormal numbers to zero (-ffast-math in a library it loads?): certified values need them");
}

} // namespace touchstone
