// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/memory.h"

namespace app {

// A text of the program's own code has no capacity. Others have a header of 16 bytes and a final 0.
std::size_t heapBytes(const QString& text)
{
    return text.capacity() == 0 ? 0 : heapBlock(16 + (std::size_t(text.capacity()) + 1) * 2);
}

std::size_t heapBytes(const Shape& shape)
{
    std::size_t bytes = heapBytes(shape.id)
                        + heapBlock(shape.style.dashes.capacity() * sizeof(double))
                        + heapBlock(shape.paths.capacity() * sizeof(Subpath));
    for (const Subpath& path : shape.paths)
        bytes += heapBlock(path.segments.capacity() * sizeof(PathSegment));
    return bytes;
}

std::size_t heapBytes(const Layer& layer) { return heapBytes(layer.name) + heapBytes(layer.id); }

} // namespace app
