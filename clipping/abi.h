// SPDX-License-Identifier: MIT
#pragma once

// How the public headers and the compiled library fit together.

/// Marks the namespace of every public header: its functions can be called from outside a shared
/// library, which hides everything else.
#define CLEARCUT_API [[gnu::visibility("default")]]

/// Marks public types that hold containers of the standard library. With `-D_GLIBCXX_DEBUG`, these
/// have another layout: a program compiled with it cannot use a library that was compiled without
/// it. The mark becomes part of the functions' names, so the linker refuses such a program, and
/// its message says what to do. Without these types, as in clearcut/clip.h, everything fits.
#ifdef _GLIBCXX_DEBUG
#define CLEARCUT_HOLDS_CONTAINERS                                                                  \
    [[gnu::abi_tag("compile_Clearcut_with_GLIBCXX_DEBUG_too_or_use_only_clearcut_clip_h")]]
#else
#define CLEARCUT_HOLDS_CONTAINERS
#endif
