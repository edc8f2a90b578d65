// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>

// How much heap memory values use. The history needs it to keep to its limit.

namespace app {

/// The heap memory of one allocation of so many bytes. glibc on 64 bits adds 8 bytes, rounds up to
/// a multiple of 16, and gives at least 32.
constexpr std::size_t heapBlock(std::size_t bytes)
{
    return bytes == 0 ? 0 : std::max<std::size_t>(32, (bytes + 8 + 15) / 16 * 16);
}

std::size_t heapBytes(const QString& text); ///< as if it shared nothing with other texts

} // namespace app
