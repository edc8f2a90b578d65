// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/window_needs.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "clipping/region/catalogue.h"

#include <algorithm>

namespace app {

WindowNeeds needsOf(const ClipRegion::Step& step)
{
    if (step.rings.empty())
        return WindowNeeds::Rectangle;
    if (step.polygon.corners.empty())
        return WindowNeeds::AnyArea;
    return step.turned ? WindowNeeds::RotatedRectangle : WindowNeeds::ConvexPolygon;
}

WindowNeeds needsOf(const ClipRegion& region)
{
    auto needs = WindowNeeds::Rectangle;
    for (const ClipRegion::Step& step : region.steps)
        needs = std::max(needs, needsOf(step));
    return needs;
}

bool canClip(const clipping::Algorithm& algorithm, WindowNeeds needs)
{
    if (needs <= WindowNeeds::RotatedRectangle || clipping::findRegionAlgorithm(algorithm.key))
        return true;
    return needs == WindowNeeds::ConvexPolygon && algorithm.polygon;
}

QString limitText(const clipping::Algorithm& algorithm, WindowNeeds needs)
{
    if (canClip(algorithm, needs))
        return {};
    return algorithm.polygon ? Text::tr("convex only") : Text::tr("rectangles only");
}

QString limitText(const Variant& variant, WindowNeeds needs)
{
    if (variant.form == clipping::Form::Published && needs > WindowNeeds::RotatedRectangle)
        return Text::tr("rectangles only");
    return limitText(*variant.algorithm, needs);
}

QString limitedName(const clipping::Algorithm& algorithm, WindowNeeds needs)
{
    const QString name = latin(algorithm.name), limit = limitText(algorithm, needs);
    return limit.isEmpty() ? name
                           : Text::tr("%1 (%2)", "name, and what it can clip").arg(name, limit);
}

// The forms for polygons and regions exist in the corrected form alone.
Variant usedAt(WindowNeeds needs, const Variant& wanted)
{
    if (needs <= WindowNeeds::RotatedRectangle)
        return wanted;
    if (canClip(*wanted.algorithm, needs))
        return {wanted.algorithm};
    return {&clipping::exactAlgorithm()};
}

Variant usedAt(const ClipRegion& region, const Variant& wanted)
{
    return usedAt(needsOf(region), wanted);
}

QString insteadText(WindowNeeds needs, const Variant& wanted)
{
    const Variant used = usedAt(needs, wanted);
    if (used == wanted)
        return {};
    const QString name = latin(wanted.algorithm->name);
    if (used.algorithm == wanted.algorithm)
        return Text::tr("The corrected form is used instead: the published one clips at rectangles "
                        "only.");
    const QString other = latin(used.algorithm->name);
    return wanted.algorithm->polygon
               ? Text::tr("%1 is used instead: %2 clips at convex windows only.").arg(other, name)
               : Text::tr("%1 is used instead: %2 clips at rectangles only.").arg(other, name);
}

QString shapeText(const ClipRegion::Step& step)
{
    std::size_t edges = 0;
    for (const auto& ring : step.rings)
        edges += ring.size();
    const QString count =
        edges == 1 ? Text::tr("1 edge") : Text::tr("%1 edges").arg(countText(edges));
    switch (needsOf(step)) {
    case WindowNeeds::Rectangle:
        return Text::tr("rectangle");
    case WindowNeeds::RotatedRectangle:
        return Text::tr("rotated rectangle");
    case WindowNeeds::ConvexPolygon:
        return Text::tr("convex, %1").arg(count);
    case WindowNeeds::AnyArea:
        break;
    }
    return step.rings.size() == 1
               ? Text::tr("concave, %1").arg(count)
               : Text::tr("%1 outlines, %2").arg(countText(step.rings.size()), count);
}

} // namespace app
