// SPDX-License-Identifier: MIT
// The floating-point state. The library computes in the default state (round to nearest, subnormals kept, nothing
// trapped), and restores the caller's state afterwards.
#pragma once

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace hrbfnpr::base {

class FpGuard {
public:
#if defined(__SSE2__)
    // All exceptions masked, round to nearest, subnormals not replaced by zero.
    static constexpr unsigned default_state = 0x1F80U;
    FpGuard() noexcept : saved_(_mm_getcsr()) { _mm_setcsr(default_state); }
    ~FpGuard() { _mm_setcsr(saved_); }
#else
    FpGuard() noexcept {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~FpGuard() { std::fesetenv(&saved_); }
#endif
    FpGuard(const FpGuard&) = delete;
    FpGuard& operator=(const FpGuard&) = delete;

private:
#if defined(__SSE2__)
    unsigned saved_;
#else
    std::fenv_t saved_;
#endif
};

} // namespace hrbfnpr::base
