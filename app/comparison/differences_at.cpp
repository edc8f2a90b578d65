// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/differences_at.h"

#include "app/base/text.h"
#include "app/scene/region_clipping.h"
#include "app/scene/window_needs.h"

namespace app {

namespace {

double ulpsOf(const ClipRegion::Step& step, const Variant& variant)
{
    const clipping::Algorithm& algorithm = *variant.algorithm;
    if (step.rings.empty())
        return algorithm.ulps;
    const bool polygon = algorithm.polygon && variant.form == clipping::Form::Corrected;
    return polygon ? clipping::polygonUlps : clipping::turnedUlps(algorithm);
}

} // namespace

QString refusalAt(const ClipRegion::Step& step, const Variant& variant)
{
    const WindowNeeds needs = needsOf(step);
    if (needs == WindowNeeds::AnyArea)
        return Text::tr("Algorithms are compared at rectangles and convex polygons; this "
                        "window is %1.")
            .arg(shapeText(step));
    const bool rotatable = needs <= WindowNeeds::RotatedRectangle;
    if (rotatable || (!variant.misprint && usedAt(needs, variant) == variant))
        return {};
    return Text::tr("%1 clips at rectangles only; this window is %2.")
        .arg(nameOf(variant), shapeText(step));
}

std::vector<clipping::Clipped> clippedAt(const ClipRegion& window, const Variant& variant,
                                         std::span<const clipping::Segment> lines)
{
    RegionClipping clipping;
    clipping.start(window, functionsOf(variant).clipAll);
    std::vector<clipping::Clipped> kept;
    clipping.fold(lines, 0, kept);
    return kept;
}

double allowedAt(const ClipRegion& window, const Comparison& comparison)
{
    const ClipRegion::Step& step = window.steps.front();
    return comparison.ulps.value_or(ulpsOf(step, comparison.a) + ulpsOf(step, comparison.b));
}

Differences differencesAt(const ClipRegion& window, const Comparison& comparison,
                          std::span<const clipping::Segment> lines)
{
    return extended({window.steps.front().box}, lines, clippedAt(window, comparison.a, lines),
                    clippedAt(window, comparison.b, lines),
                    {allowedAt(window, comparison), endsOf(comparison.a, comparison.b)});
}

QString atText(const ComparedWindow& window)
{
    return window.isPage ? Text::tr("At the page: no clip window along the axes.") : QString();
}

} // namespace app
