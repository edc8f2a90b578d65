// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace app {

/// Bytes that this process can still get: the least of what the system has available, what its
/// control groups leave, and what RLIMIT_AS leaves. The largest number if the system tells nothing.
/// A request beyond it may end the process instead of failing.
std::uint64_t freeMemory();

/// Asks, while more and more memory is used, whether there is enough for more.
class MemoryWatch {
public:
    MemoryWatch();
    /// False if little memory is left. Looks at one call of many only.
    bool isEnough();

private:
    std::uint64_t reserve_; ///< bytes
    unsigned calls_ = 0;
};

/// Why something cannot be opened, if it needs more bytes than are free; otherwise empty. The
/// sentence follows "Cannot open NAME: ".
QString memoryFault(std::uint64_t needed);
/// The same where it is seen while reading, to follow "line 12 ".
QString memoryEnds();

} // namespace app
