// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/shaped_window.h"

#include "app/base/number.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/comparison/differences_at.h"
#include "app/experiment/one_by_one.h"
#include "app/formats/coordinates.h"
#include "app/scene/step_clipping.h"
#include "app/scene/window_needs.h"

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace app {
namespace {

bool isUnable(const ShapedWindow& window, const Variant& variant)
{
    return !refusalAt(window.step(), variant).isEmpty();
}

// y grows down, and angles are given counterclockwise as seen.
QString textOf(const ClipWindow& window, const ClipRegion::Step& step)
{
    if (const auto* rectangle = std::get_if<RectangleShape>(&window.shape))
        return QStringLiteral("%1@%2").arg(rectangleText(rectangle->box),
                                           shortestText(-glm::degrees(rectangle->angle)));
    QStringList corners;
    for (const Point& corner : step.polygon.corners)
        corners << QStringLiteral("%1,%2").arg(shortestText(corner.x), shortestText(corner.y));
    return QStringLiteral("polygon:") + corners.join(u' ');
}

} // namespace

std::shared_ptr<const ShapedWindow> shapedWindow(const ClipWindow& window, const Page& page,
                                                 const QString& text)
{
    ShapedWindow shaped{regionOf({{window}}, page), text};
    if (shaped.region.steps.empty() || needsOf(shaped.step()) == WindowNeeds::Rectangle)
        return nullptr;
    if (text.isEmpty())
        shaped.text = textOf(window, shaped.step());
    return std::make_shared<const ShapedWindow>(std::move(shaped));
}

QString refusalOf(const ShapedWindow& window)
{
    if (needsOf(window.step()) != WindowNeeds::AnyArea)
        return {};
    return Text::tr("Algorithms are timed at rectangles and convex polygons; this window is "
                    "%1.")
        .arg(shapeText(window.step()));
}

std::size_t clipAllAt(const ShapedWindow& window, const Variant& variant,
                      std::span<const clipping::Segment> in, std::span<clipping::Clipped> out)
{
    const auto* uses = clipping::functionsOf(*variant.algorithm, variant.form);
    return clipAtStep(formsAt(window.region, uses->clipAll), window.step(), in, out);
}

// Line by line, `exact` would check the polygon again for each line.
std::vector<Variant> withoutUnable(const ShapedWindow& window, std::vector<Variant> variants)
{
    variants = withoutOneByOne(variants);
    std::erase_if(variants, [&](const Variant& one) { return isUnable(window, one); });
    return variants;
}

QString unableText(const ShapedWindow& window, std::span<const Variant> variants)
{
    QStringList names;
    for (const Variant& one : withoutOneByOne(variants))
        if (isUnable(window, one))
            names << shortNameOf(one);
    if (names.isEmpty())
        return {};
    return Text::tr("Left out, because they clip at rectangles only: %1.")
        .arg(briefListText(names));
}

} // namespace app
