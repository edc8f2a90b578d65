// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_wish.h"

#include <cmath>

namespace app {

bool isSameClipping(const FrameKey& a, const FrameKey& b)
{
    return a.lines == b.lines && a.variant == b.variant && a.region == b.region;
}

bool isSameBase(const FrameKey& a, const FrameKey& b)
{
    return a.lines == b.lines && a.images == b.images && a.view.size == b.view.size
           && a.pixels == b.pixels && a.pixelRatio == b.pixelRatio;
}

bool isSameView(const FrameKey& a, const FrameKey& b)
{
    return isSameBase(a, b) && a.view == b.view;
}

std::optional<QPoint> wholePixelsBetween(const FrameKey& a, const FrameKey& b)
{
    constexpr double most = 1e6, unseen = 1e-6; // device pixels
    if (!isSameBase(a, b) || a.view.zoom != b.view.zoom)
        return {};
    const Point by = (a.view.centre - b.view.centre) * a.view.zoom * a.pixelRatio;
    if (!(std::abs(by.x) < most && std::abs(by.y) < most))
        return {};
    const QPoint whole(qRound(by.x), qRound(by.y));
    const bool isWhole = std::abs(by.x - whole.x()) < unseen && std::abs(by.y - whole.y()) < unseen;
    return isWhole ? std::optional(whole) : std::nullopt;
}

PictureOptions FrameWish::pictureOptions() const
{
    PictureOptions all = options;
    all.view = key.view;
    all.region = &key.region;
    all.borders = key.borders;
    all.selection = selection.ranges();
    all.underlays = underlays;
    if (differing)
        all.differing = *differing;
    for (const auto& [pieces, colour] : graded)
        all.graded.push_back({*pieces, colour});
    return all;
}

RasterOptions FrameWish::rasterOptions(const std::stop_token& stop) const
{
    return {key.pixels.width(), key.pixelRatio, ghost, [stop] { return stop.stop_requested(); }};
}

} // namespace app
