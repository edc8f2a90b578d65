// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/edit.h"

#include "app/base/memory.h"

#include <cassert>

namespace app {
namespace {

bool sharesPoints(const PathShape& shape, const WindowShape& other)
{
    const auto* path = std::get_if<PathShape>(&other);
    return path && path->path.heapPart().address == shape.path.heapPart().address;
}

// Copies of the list share only the names and the paths of windows.
std::size_t bytesNotIn(const ClipWindows& windows, const ClipWindows& other)
{
    std::size_t sum = heapBytes(windows.list);
    for (std::size_t i = 0; i < windows.list.size(); ++i) {
        const ClipWindow& window = windows.list[i];
        if (i >= other.list.size() || other.list[i].name.constData() != window.name.constData())
            sum += heapBytes(window.name);
        if (const auto* shape = std::get_if<PathShape>(&window.shape);
            shape && (i >= other.list.size() || !sharesPoints(*shape, other.list[i].shape)))
            sum += shape->path.heapPart().bytes;
    }
    return sum;
}

} // namespace

std::size_t Edit::bytesNotIn(const Edit& opposite) const
{
    std::size_t sum = heapBytes(splices) + heapBytes(moved) + heapBytes(numbers)
                      + objects.bytesNotIn(opposite.objects);
    assert(containers.has_value() == opposite.containers.has_value());
    assert(windows.has_value() == opposite.windows.has_value());
    if (containers)
        sum += containers->bytesNotIn(*opposite.containers);
    if (windows)
        sum += app::bytesNotIn(*windows, *opposite.windows);
    return sum;
}

std::vector<Splice> inverse(std::span<const Splice> splices)
{
    std::vector<Splice> back;
    back.reserve(splices.size());
    std::uint32_t removed = 0, added = 0; // by the previous splices
    for (const Splice& s : splices) {
        back.push_back({s.first - removed + added, s.added, s.removed});
        removed += s.removed;
        added += s.added;
    }
    return back;
}

ObjectRanges addedBy(std::span<const Splice> splices)
{
    ObjectRanges added;
    for (const Splice& s : inverse(splices))
        added.insert(ObjectRange{s.first, std::size_t(s.first) + s.removed});
    return added;
}

} // namespace app
