// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/traced_line.h"

#include "app/base/text.h"

#include <array>
#include <cmath>

namespace app {

QString edgeWords(clipping::Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> up{
        "", QT_TRANSLATE_NOOP("Text", "the left edge"), QT_TRANSLATE_NOOP("Text", "the right edge"),
        QT_TRANSLATE_NOOP("Text", "the bottom edge"), QT_TRANSLATE_NOOP("Text", "the top edge")};
    if (edge == clipping::Edge::NoEdge || edge > clipping::Edge::Top)
        return {};
    return Text::tr(up[seenEdge(edge, y)]);
}

namespace {

/// "Cyrus-Beck, Skala and Exact": the rows that clip at convex polygons.
QString polygonNames()
{
    QStringList names;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        if (algorithm.polygon)
            names << latin(algorithm.name);
    const QString last = names.takeLast();
    return names.isEmpty() ? last
                           : Text::tr("%1 or %2").arg(names.join(QStringLiteral(", ")), last);
}

QString polygonRefusal(const Variant& variant)
{
    const QString name = latin(variant.algorithm->name);
    return variant.algorithm->polygon
               ? Text::tr("The published form of %1 clips at rectangles only. Choose the "
                          "corrected form.")
                     .arg(name)
               : Text::tr("%1 clips at rectangles only. Choose %2.").arg(name, polygonNames());
}

} // namespace

// The forms for polygons exist in the corrected form alone.
const clipping::Functions<clipping::Segment, clipping::ConvexPolygon>*
polygonUsesOf(const Variant& variant)
{
    const bool corrected = variant.form == clipping::Form::Corrected && !variant.misprint;
    return corrected ? variant.algorithm->polygon : nullptr;
}

QString refusalOf(const TracedLine& tracedLine)
{
    if (!tracedLine.corners.empty() && !polygonUsesOf(tracedLine.variant))
        return polygonRefusal(tracedLine.variant);
    const auto& [a, b] = tracedLine.line;
    const auto& [min, max] = tracedLine.window;
    struct Row {
        const char* name;
        double value;
    };
    for (const Row& row :
         {Row{"x1", a.x}, Row{"y1", a.y}, Row{"x2", b.x}, Row{"y2", b.y}, Row{"xmin", min.x},
          Row{"ymin", min.y}, Row{"xmax", max.x}, Row{"ymax", max.y}})
        if (!std::isfinite(row.value))
            return Text::tr("%1 is not a finite number: nothing is clipped. Give it another value.")
                .arg(latin(row.name));
    if (min.x > max.x || min.y > max.y)
        return Text::tr(
            "The window's minimum lies beyond its maximum: nothing is clipped. Swap them.");
    return {};
}

} // namespace app
