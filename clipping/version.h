// SPDX-License-Identifier: MIT
#pragma once

// The version of the library, by the rules of https://semver.org. CMakeLists.txt reads it here.
// Before 1.0 each minor version may change the compiled interface: compile your program again.

#define CLEARCUT_VERSION_MAJOR 0
#define CLEARCUT_VERSION_MINOR 1
#define CLEARCUT_VERSION_PATCH 0

/// One number to compare: 100 for 0.1.0, 10203 for 1.2.3.
#define CLEARCUT_VERSION                                                                           \
    (CLEARCUT_VERSION_MAJOR * 10000 + CLEARCUT_VERSION_MINOR * 100 + CLEARCUT_VERSION_PATCH)
