// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether this is a build with the address or the thread sanitizer.
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

/// These sanitizers reserve terabytes of address space, so such a program cannot be run with a
/// limit on its memory.
constexpr bool memoryCanBeLimited = !isSanitized;
