// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/edit.h"

namespace app {
namespace {

std::size_t ownBytesOf(const ClipWindow& window)
{
    const auto* polygon = std::get_if<PolygonShape>(&window.shape);
    return sizeof window + std::size_t(window.name.capacity()) * sizeof(QChar)
           + (polygon ? polygon->corners.capacity() * sizeof polygon->corners[0] : 0);
}

} // namespace

std::size_t Edit::ownBytes() const
{
    std::size_t sum = sizeof *this + splices.capacity() * sizeof splices[0] + objects.ownBytes();
    if (windows)
        for (const ClipWindow& window : windows->list)
            sum += ownBytesOf(window);
    return sum;
}

std::vector<Splice> inverse(std::span<const Splice> splices)
{
    std::vector<Splice> back;
    back.reserve(splices.size());
    std::uint32_t removed = 0, added = 0; // by the splices before
    for (const Splice& s : splices) {
        back.push_back({s.first - removed + added, s.added, s.removed});
        removed += s.removed;
        added += s.added;
    }
    return back;
}

} // namespace app
