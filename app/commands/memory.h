// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

#include <algorithm>

// How much heap memory values use. The history needs it to keep to its limit.

namespace app {

/// The heap memory of one allocation of so many bytes. glibc on 64 bits adds 8 bytes, rounds up to
/// a multiple of 16, and gives at least 32.
constexpr std::size_t heapBlock(std::size_t bytes)
{
    return bytes == 0 ? 0 : std::max<std::size_t>(32, (bytes + 8 + 15) / 16 * 16);
}

/// Heap bytes; each value counts as if it shared nothing with others (texts do).
std::size_t heapBytes(const QString& text);
std::size_t heapBytes(const Shape& shape);
std::size_t heapBytes(const Layer& layer);

template <class Value>
std::size_t heapBytes(const std::vector<Value>& values)
{
    std::size_t bytes = heapBlock(values.capacity() * sizeof(Value));
    for (const Value& value : values)
        bytes += heapBytes(value);
    return bytes;
}

} // namespace app
