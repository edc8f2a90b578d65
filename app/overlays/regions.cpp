// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/overlays/half_plane.h"
#include "app/overlays/parts.h"
#include "clipping/outcode.h"

#include <glm/common.hpp>

namespace app {

using clipping::Edge;

namespace {

/// The rectangle with that outcode, clipped to the visible part.
std::vector<Point> regionCorners(unsigned code, const clipping::Window& window,
                                 const clipping::Window& seen)
{
    clipping::Window region = window;
    for (const Edge edge : windowEdges) {
        const auto axis = clipping::axisOf(edge);
        if (!(code & bitOf(edge)))
            continue;
        const bool low = edge == clipping::lowerEdge(axis);
        (low ? region.max : region.min)[axis] = clipping::levelOf(edge, window);
        (low ? region.min : region.max)[axis] = (low ? seen.min : seen.max)[axis];
    }
    return common({glm::max(region.min, seen.min), glm::min(region.max, seen.max)}, {});
}

std::uint32_t setBits(const QString& code)
{
    std::uint32_t bits = 0;
    for (qsizetype i = 0; i < code.size(); ++i)
        bits |= std::uint32_t(code[i] == u'1') << i;
    return bits;
}

} // namespace

std::vector<OverlayArea> regionsNamed(const OverlayContext& context,
                                      QString (*name)(unsigned code, YAxis y))
{
    std::optional<unsigned> pointed;
    if (context.pointer)
        pointed = clipping::outcodeOf(*context.pointer, context.window);
    std::vector<OverlayArea> areas;
    for (const unsigned code : {5U, 4U, 6U, 1U, 0U, 2U, 9U, 8U, 10U})
        areas.push_back({.corners = regionCorners(code, context.window, context.seen),
                         .label = name(code, context.y),
                         .pointed = code == pointed});
    return areas;
}

std::vector<OverlayArea> outcodeRegions(const OverlayContext& context)
{
    std::vector<OverlayArea> areas =
        regionsNamed(context, [](unsigned code, YAxis) { return outcodeText(code); });
    for (OverlayArea& area : areas)
        area.strong = setBits(area.label);
    return areas;
}

std::optional<OverlayLine> border(Edge edge, const OverlayContext& context)
{
    const auto axis = clipping::axisOf(edge);
    const double level = clipping::levelOf(edge, context.window);
    if (level < context.seen.min[axis] || level > context.seen.max[axis])
        return std::nullopt;
    clipping::Segment line{context.seen.min, context.seen.max};
    line.a[axis] = line.b[axis] = level;
    return OverlayLine{.segment = line};
}

std::vector<OverlayLine> regionBorders(const OverlayContext& context)
{
    std::vector<OverlayLine> lines;
    for (const Edge edge : windowEdges)
        if (const auto line = border(edge, context))
            lines.push_back(*line);
    return lines;
}

std::vector<OverlayMark> endMarks(const clipping::Segment& line, const QString& ofA,
                                  const QString& ofB)
{
    const auto mark = [](const Point& at, bool isB, const QString& word) {
        return OverlayMark{.at = at,
                           .label = word.isEmpty() ? endName(isB)
                                                   : endName(isB) + QStringLiteral("  ") + word};
    };
    return {mark(line.a, false, ofA), mark(line.b, true, ofB)};
}

CodePair codesOf(const OverlayContext& context)
{
    return {clipping::outcodeOf(context.line->a, context.window),
            clipping::outcodeOf(context.line->b, context.window)};
}

OverlayTable codeTable(const OverlayContext& context)
{
    const auto [a, b] = codesOf(context);
    OverlayTable table{{QString(), Text::tr("code")},
                       {{endName(false), outcodeText(a)},
                        {endName(true), outcodeText(b)},
                        {QStringLiteral("AND"), outcodeText(a & b)},
                        {QStringLiteral("OR"), outcodeText(a | b)}}};
    if ((a & b) != 0)
        table.highlightedRow = 2;
    else if ((a | b) == 0)
        table.highlightedRow = 3;
    return table;
}

QString codeWords(const OverlayContext& context)
{
    const auto [a, b] = codesOf(context);
    if ((a | b) == 0)
        return Text::tr("Both outcodes are 0000: the whole line is inside.");
    if ((a & b) == 0)
        return Text::tr(
            "The outcodes have no bit in common and are not both 0000: they do not decide.");
    QStringList names;
    for (const Edge edge : windowEdges)
        if (a & b & bitOf(edge))
            names << edgeWords(edge, context.y);
    return Text::tr(
               "The outcodes have a bit in common: both ends are beyond %1, so nothing is visible.")
        .arg(names.join(Text::tr(" and ")));
}

} // namespace app
