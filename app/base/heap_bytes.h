// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <cstddef>
#include <vector>

// How much heap memory values use. The history needs it to keep to its limit.

namespace app {

/// The heap memory of one allocation of so many bytes. glibc on 64 bits adds 8 bytes, rounds up to
/// a multiple of 16, and gives at least 32.
constexpr std::size_t heapBlock(std::size_t bytes)
{
    return bytes == 0 ? 0 : std::max<std::size_t>(32, (bytes + 8 + 15) / 16 * 16);
}

/// As if it shared nothing with other texts. A text of the program's own code uses none; others
/// have a header of 16 bytes and a final 0.
inline std::size_t heapBytes(const QString& text)
{
    return text.capacity() == 0 ? 0 : heapBlock(16 + (std::size_t(text.capacity()) + 1) * 2);
}

/// Without what its elements use.
template <class T>
std::size_t heapBytes(const std::vector<T>& list)
{
    return heapBlock(list.capacity() * sizeof(T));
}

/// An allocation that several values may share.
struct HeapPart {
    const void* address = nullptr; ///< null: there is none
    std::size_t bytes = 0;
    bool shared = false;
};

} // namespace app
