// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The address and the thread sanitizer reserve terabytes of address space, so in their presets a
/// program cannot be run with a limit on its memory.
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
constexpr bool memoryCanBeLimited = false;
#else
constexpr bool memoryCanBeLimited = true;
#endif
