// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <cstddef>
#include <vector>

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
