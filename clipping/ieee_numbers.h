// SPDX-License-Identifier: MIT
#pragma once

// Every .cpp file of the library includes this, and no installed header does: a program may be
// compiled with -ffast-math, the library must not be, because `exact` would return NaN. The CMake
// target turns the option off; other build systems get this error.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Clearcut's library needs the floating point of IEEE 754: compile it with -fno-fast-math"
#endif
