// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

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

// The heap memory that values use. The history needs these numbers to keep within its limit.

namespace app {

/// The heap memory that one allocation of `bytes` bytes takes. glibc on 64 bits adds 8 bytes,
/// rounds up to a multiple of 16, and uses at least 32.
constexpr std::size_t heapBlock(std::size_t bytes)
{
    return bytes == 0 ? 0 : std::max<std::size_t>(32, (bytes + 8 + 15) / 16 * 16);
}

/// The memory of the text as if no other text shared it. A text literal uses none; any other text
/// has a header of 16 bytes and a terminating 0.
inline std::size_t heapBytes(const QString& text)
{
    return text.capacity() == 0 ? 0 : heapBlock(16 + (std::size_t(text.capacity()) + 1) * 2);
}

/// The memory of the list itself, without the memory that its elements use.
template <class T>
std::size_t heapBytes(const std::vector<T>& list)
{
    return heapBlock(list.capacity() * sizeof(T));
}

/// An allocation that several values may share.
struct HeapPart {
    const void* address = nullptr; ///< null: no allocation
    std::size_t bytes = 0;
    bool shared = false;
};

} // namespace app
