// SPDX-License-Identifier: MIT
/// One target for libFuzzer: TOUCHSTONE_FUZZ_TARGET is its function.
#include "tests/fuzz/targets.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    touchstone::fuzz::TOUCHSTONE_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
