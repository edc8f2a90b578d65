// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/memory.h"

namespace app {

// A text of the program's own code has no capacity. Others have a header of 16 bytes and a final 0.
std::size_t heapBytes(const QString& text)
{
    return text.capacity() == 0 ? 0 : heapBlock(16 + (std::size_t(text.capacity()) + 1) * 2);
}

} // namespace app
