// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_wish.h"

namespace app {

bool isSameClipping(const FrameKey& a, const FrameKey& b)
{
    return a.lines == b.lines && a.variant == b.variant && a.region == b.region;
}

bool isSameBase(const FrameKey& a, const FrameKey& b)
{
    return a.lines == b.lines && a.view.size == b.view.size && a.pixels == b.pixels
           && a.pixelRatio == b.pixelRatio;
}

bool isSameView(const FrameKey& a, const FrameKey& b)
{
    return isSameBase(a, b) && a.view == b.view;
}

PictureOptions FrameWish::pictureOptions() const
{
    PictureOptions all = options;
    all.view = key.view;
    all.region = &key.region;
    all.borders = key.borders;
    all.selection = selection.ranges();
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
