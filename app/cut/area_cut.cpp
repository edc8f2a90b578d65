// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/area_cut.h"

#include "app/cut/area_outline.h"
#include "app/scene/area_windows.h"

namespace app {
AreaCut::AreaCut(const ClipRegion& region, const std::stop_token& stop)
    : windows_(areaWindows(region)), stop_(stop)
{
}

AreaLeft AreaCut::left(const Path& path, FillRule rule, std::span<const Chord> chords,
                       const CurvedBorder& border) const
{
    const std::vector<Subpath> subpaths = path.subpaths();
    const FlatArea flat = flatAreaOf(subpaths, rule, chords);
    const clipping::ClippedArea clipped = clipping::clipArea(flat.area, *windows_, stop_);
    if (clipped.part == clipping::AreaPart::Whole)
        return {.whole = true};
    if (clipped.part != clipping::AreaPart::Cut)
        return {};
    return {.paths = subpathsOf(clipped, subpaths, flat, *windows_, border)};
}

} // namespace app
