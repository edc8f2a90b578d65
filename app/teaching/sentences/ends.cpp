// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/ends.h"

#include "app/base/text.h"
#include "app/comparison/ulps.h"
#include "app/overlays/half_plane.h"
#include "app/teaching/sentences/words.h"
#include "clipping/outcode.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::words {

using clipping::Edge;

namespace {

/// The distance of a point outside a window; 0 if it is not outside.
double outside(const Point& p, const clipping::Window& window)
{
    return std::max(
        {window.min.x - p.x, p.x - window.max.x, window.min.y - p.y, p.y - window.max.y, 0.0});
}

/// An edge that both ends of the original line lie beyond.
Edge commonEdge(const TracedLine& tracedLine)
{
    const unsigned common = clipping::outcodeOf(tracedLine.line.a, tracedLine.window)
                            & clipping::outcodeOf(tracedLine.line.b, tracedLine.window);
    return common & clipping::outcode::left     ? Edge::Left
           : common & clipping::outcode::right  ? Edge::Right
           : common & clipping::outcode::bottom ? Edge::Bottom
                                                : Edge::Top;
}

/// The exact visible part.
std::optional<clipping::Segment> exactPiece(const TracedLine& tracedLine)
{
    return clipping::exactAlgorithm().corrected.clip(tracedLine.line, tracedLine.window);
}

} // namespace

Point endOf(int number, const SentenceContext& context)
{
    return number == 1 ? context.step.segment.a : context.step.segment.b;
}

bool isBeyond(const SentenceContext& context, int number, Edge edge)
{
    return edge != Edge::NoEdge
           && app::isBeyond(endOf(number, context), edge, context.tracedLine.window);
}

QString whetherBeyond(const SentenceContext& context, int number)
{
    const QString side = beyond(context.edge(), context.tracedLine.y);
    const QString relation =
        compared(endOf(number, context), context.edge(), context.tracedLine.window);
    return isBeyond(context, number, context.edge())
               ? Text::tr("%1 lies %2 (%3)").arg(end(number), side, relation)
               : Text::tr("%1 does not lie %2 (%3)").arg(end(number), side, relation);
}

bool asksTheWay(const SentenceContext& context)
{
    return context.known("moved") == 1 && clipping::axisOf(context.edge()) == 1;
}

QString whetherPassed(const SentenceContext& context, int number)
{
    const double rise = context.known("rise").value_or(0);
    const double gap = clipping::levelOf(context.edge(), context.tracedLine.window)
                       - context.known("yi").value_or(0);
    return (context.holds()
                ? Text::tr("%1 has moved by %3 in y, and %2 was %4 away (%5): %1 has passed "
                           "that edge and lies %6.")
                : Text::tr("%1 has moved by %3 in y, and %2 was %4 away (%5): %1 has not "
                           "passed that edge and does not lie %6."))
        .arg(end(number), context.edgeText(), words::number(rise), words::number(gap),
             compared(rise, gap), beyond(context.edge(), context.tracedLine.y));
}

QString bothBeyond(const SentenceContext& context)
{
    const auto& [a, b] = context.tracedLine.line;
    const Edge edge =
        context.edge() != Edge::NoEdge ? context.edge() : commonEdge(context.tracedLine);
    const auto& window = context.tracedLine.window;
    return Text::tr("Both ends lie %1 (%2 and %3): no point of the line can be inside.")
        .arg(beyond(edge, context.tracedLine.y), compared(a, edge, window),
             compared(b, edge, window));
}

QString corner(Edge one, Edge other, YAxis y)
{
    static constexpr std::array<const char*, 4> corners{
        QT_TRANSLATE_NOOP("Text", "the bottom left corner"),
        QT_TRANSLATE_NOOP("Text", "the bottom right corner"),
        QT_TRANSLATE_NOOP("Text", "the top left corner"),
        QT_TRANSLATE_NOOP("Text", "the top right corner")};
    if (one > other)
        std::swap(one, other);
    if (one == Edge::NoEdge || one > Edge::Right || other < Edge::Bottom)
        return {};
    const bool top = (other == Edge::Top) == (y == YAxis::Up);
    return Text::tr(corners[(top ? 2 : 0) + (one == Edge::Right ? 1 : 0)]);
}

QString outcodes(const SentenceContext& context)
{
    const auto code = [&](const char* name) {
        return outcodeText(unsigned(context.value(name).value_or(0)));
    };
    return Text::tr("The outcode of End 1 is %1, that of End 2 is %2. Their bits mean %3.")
        .arg(code("code1"), code("code2"), outcodeBits());
}

QString productsTooLarge(const QString& products, const QString& corner)
{
    return Text::tr("The products overflow (%1): what they say about %2 is meaningless, but the "
                    "algorithm relies on it.")
        .arg(products, corner);
}

QString value(const SentenceContext& context, std::string_view name)
{
    const auto value = context.value(name);
    return value ? number(*value) : QString();
}

QString held(const SentenceContext& context)
{
    return context.before && context.before->segment != context.step.segment
               ? Text::tr(
                   "Rounding had put an end just outside the window: it is moved back to the edge.")
               : Text::tr(
                   "Rounding has put no end outside the window, so both stay where they are.");
}

/// That the accepted part is not the one inside; empty if it is, but for what the algorithm's
/// contract allows.
static QString elsewhere(const SentenceContext& context)
{
    const auto piece = exactPiece(context.tracedLine);
    const auto& traced = context.tracedLine;
    if (!isPublished(context) || !piece)
        return {};
    const clipping::Segment& left = context.step.segment;
    const double allowed = traced.variant.algorithm->ulps * ulpFor(traced.line, traced.window);
    const QString from = point(piece->a), to = point(piece->b);
    const bool looksSame = (from == point(left.a) && to == point(left.b))
                           || (from == point(left.b) && to == point(left.a));
    if (looksSame || !(endsApart(*piece, left, Ends::EitherWay) > allowed))
        return {};
    return QStringLiteral(" ")
           + Text::tr("That is wrong: what lies inside runs from %1 to %2.").arg(from, to);
}

QString acceptedIfInside(const SentenceContext& context)
{
    for (const int end : {1, 2})
        if (const Point p = endOf(end, context); std::isnan(p.x) || std::isnan(p.y))
            return Text::tr("The remaining part is accepted, but %1 is no longer a point: %2.")
                .arg(words::end(end), point(p));
    for (const int end : {1, 2})
        if (const double far = outside(endOf(end, context), context.tracedLine.window); far > 0)
            return (std::isfinite(far)
                        ? Text::tr("The remaining part is accepted, but rounding has left "
                                   "%1 outside the window by %2.")
                        : Text::tr("The remaining part is accepted, but an overflow has "
                                   "left %1 outside the window by %2."))
                .arg(words::end(end), words::number(far));
    if (!exactPiece(context.tracedLine))
        return accepted(context) + QStringLiteral(" ")
               + Text::tr(
                   "That is wrong: the line misses the window by less than a rounding error.");
    return accepted(context) + elsewhere(context);
}

QString lost(const SentenceContext& context)
{
    if (!isPublished(context))
        return {};
    const auto piece = exactPiece(context.tracedLine);
    if (!piece)
        return {};
    return QStringLiteral(" ")
           + (piece->a == piece->b ? Text::tr("That is wrong: the line touches the window at %1.")
                                         .arg(point(piece->a))
                                   : Text::tr("That is wrong: from %1 to %2 the line is inside.")
                                         .arg(point(piece->a), point(piece->b)));
}

} // namespace app::words
