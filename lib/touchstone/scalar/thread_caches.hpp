// SPDX-License-Identifier: MIT
/// \file
/// What FLINT and MPFR keep for each thread ends with the thread, however it ends.
#pragma once

#include "touchstone/scalar/flint_headers.hpp"

namespace touchstone {

/// To be called in a thread before it computes, as often as one likes. \note FLINT may be used afterwards as before.
inline void release_caches_with_thread()
{
    struct AtEnd {
        ~AtEnd() { flint_cleanup(); }
    };
    thread_local const AtEnd at_end;
    (void)at_end;
}

} // namespace touchstone
