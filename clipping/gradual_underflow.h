// SPDX-License-Identifier: MIT
#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace clipping {

/// While it lives, numbers that are too small for a full significand are not taken for 0. A program
/// that is linked with -ffast-math takes them for 0 (the processor's modes FTZ and DAZ), also in
/// libraries, and `exact` would decide wrongly. Reading the mode costs about a nanosecond; it is
/// written only where it is wrong.
class GradualUnderflow {
public:
    GradualUnderflow() noexcept
    {
        if (flushed_ != 0) [[unlikely]]
            write(read() & ~flush);
    }
    ~GradualUnderflow()
    {
        if (flushed_ != 0) [[unlikely]]
            write(read() | flushed_);
    }
    GradualUnderflow(const GradualUnderflow&) = delete;
    GradualUnderflow& operator=(const GradualUnderflow&) = delete;

private:
#if defined(__SSE2__)
    using Mode = unsigned;
    static constexpr Mode flush = 0x8040; // flush to zero, denormals are zero
    static Mode read() noexcept { return _mm_getcsr(); }
    static void write(Mode mode) noexcept { _mm_setcsr(mode); }
#elif defined(__aarch64__)
    using Mode = unsigned long;
    static constexpr Mode flush = 1UL << 24;
    static Mode read() noexcept
    {
        Mode mode;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static void write(Mode mode) noexcept { asm volatile("msr fpcr, %0" : : "r"(mode)); }
#else
    using Mode = unsigned;
    static constexpr Mode flush = 0;
    static Mode read() noexcept { return 0; }
    static void write(Mode) noexcept {}
#endif
    const Mode flushed_ = read() & flush;
};

} // namespace clipping
