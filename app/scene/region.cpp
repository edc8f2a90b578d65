// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/region.h"

#include <cmath>

namespace app {
namespace {

bool isFinite(const clipping::Window& box)
{
    return std::isfinite(box.min.x) && std::isfinite(box.min.y) && std::isfinite(box.max.x)
           && std::isfinite(box.max.y);
}

// Whether the box is finite and not inverted, so that it contains at least one point.
bool isProper(const clipping::Window& box)
{
    return isFinite(box) && box.min.x <= box.max.x && box.min.y <= box.max.y;
}

/// How much of a box a set of points contains.
enum class Share : std::uint8_t { None, All, Some };

Share shareIn(const clipping::Window& window, const clipping::Window& box)
{
    if (!isProper(window) || box.max.x < window.min.x || box.min.x > window.max.x
        || box.max.y < window.min.y || box.min.y > window.max.y)
        return Share::None;
    const bool all = box.min.x >= window.min.x && box.max.x <= window.max.x
                     && box.min.y >= window.min.y && box.max.y <= window.max.y;
    return all ? Share::All : Share::Some;
}

Share opposite(Share share)
{
    return share == Share::None ? Share::All : share == Share::All ? Share::None : Share::Some;
}

Share either(Share a, Share b)
{
    if (a == Share::All || b == Share::All)
        return Share::All;
    return a == Share::None && b == Share::None ? Share::None : Share::Some;
}

Share both(Share a, Share b) { return opposite(either(opposite(a), opposite(b))); }

Share after(WindowOperation operation, Share before, Share window)
{
    if (operation == WindowOperation::Add)
        return either(before, window);
    return both(before, operation == WindowOperation::CutOut ? opposite(window) : window);
}

} // namespace

std::optional<clipping::Window> ClipRegion::single() const
{
    if (steps.size() != 1 || steps.front().operation == WindowOperation::CutOut)
        return std::nullopt;
    return steps.front().box;
}

ClipRegion regionOf(const ClipWindows& windows)
{
    ClipRegion region{{}, windows.keep};
    for (const ClipWindow& window : windows.list)
        if (const auto box = axisAlignedBox(window.shape); box && window.visible)
            region.steps.push_back({*box, window.operation});
    return region;
}

Remains remainsOf(const ClipRegion& region, const clipping::Window& box)
{
    if (region.everything())
        return Remains::Whole;
    if (!isProper(box))
        return Remains::Pieces;
    Share share = region.startsFull() ? Share::All : Share::None;
    for (const auto& [window, operation] : region.steps)
        share = after(operation, share, shareIn(window, box));
    if (share == Share::Some)
        return Remains::Pieces;
    return (share == Share::All) == (region.keep == Keep::Inside) ? Remains::Whole : Remains::Gone;
}

} // namespace app
