// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/words.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/line_text.h"

#include <bit>
#include <cmath>

namespace app::words {

namespace {

double axisOf(const Point& p, clipping::Edge edge) { return p[clipping::axisOf(edge)]; }

} // namespace

QString beyond(clipping::Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> words{
        QT_TRANSLATE_NOOP("Text", "outside the window"),
        QT_TRANSLATE_NOOP("Text", "left of the window"),
        QT_TRANSLATE_NOOP("Text", "right of the window"),
        QT_TRANSLATE_NOOP("Text", "below the window"),
        QT_TRANSLATE_NOOP("Text", "above the window")};
    return Text::tr(words.at(seenEdge(edge, y)));
}

QString axisName(clipping::Edge edge)
{
    return clipping::axisOf(edge) == 0 ? QStringLiteral("x") : QStringLiteral("y");
}

QString end(int number) { return Text::tr("End %1").arg(number); }

QString point(const Point& p) { return pairText(number(p.x), number(p.y)); }

QString number(double value)
{
    if (std::isnan(value))
        return Text::tr("NaN");
    if (std::isinf(value))
        return value > 0 ? Text::tr("infinity") : Text::tr("minus infinity");
    return shortText(value);
}

QString compared(double one, double other)
{
    const QString sign = one < other    ? QStringLiteral("<")
                         : one > other  ? QStringLiteral(">")
                         : one == other ? QStringLiteral("=")
                                        : QStringLiteral("≠"); // NaN
    const bool alike = one != other && shortText(one) == shortText(other);
    return QStringLiteral("%1 %2 %3")
        .arg(alike ? exactText(one) : number(one), sign, alike ? exactText(other) : number(other));
}

QString compared(const Point& p, clipping::Edge edge, const clipping::Window& window)
{
    return compared(axisOf(p, edge), clipping::levelOf(edge, window));
}

clipping::Edge edgeOf(unsigned code)
{
    return code == 0 ? clipping::Edge::NoEdge : clipping::Edge(std::countr_zero(code) + 1);
}

QString codeAndRegion(unsigned code, YAxis y)
{
    return QStringLiteral("%1 (%2)").arg(outcodeText(code), regionText(code, y));
}

unsigned bits(const SentenceContext& context, std::string_view name)
{
    return unsigned(context.value(name).value_or(0));
}

QString way(const SentenceContext& context, const QString& from, const Point& start, double gone,
            std::optional<double> slope)
{
    const auto along = clipping::axisOf(context.edge());
    const double away = clipping::levelOf(context.edge(), context.tracedLine.window) - start[along];
    const QString x = axisName(context.edge()),
                  y = along == 0 ? QStringLiteral("y") : QStringLiteral("x");
    if (!std::isfinite(gone))
        return slope
                   ? Text::tr("The slope overflows (%1): every product with it is meaningless.")
                         .arg(number(*slope))
                   : Text::tr(
                         "The numbers are too large: their product overflows (%1), and everything "
                         "computed from it is meaningless.")
                         .arg(number(gone));
    const QString text =
        Text::tr("From %1 to %2, %4 changes by %3.").arg(from, context.edgeText(), number(away), x);
    return text + u' '
           + (slope ? Text::tr("For each unit of %1, %3 changes by %2; in all, %3 changes by %4.")
                          .arg(x, number(*slope), y, number(gone))
                    : Text::tr("Meanwhile %2 changes by %1.").arg(number(gone), y));
}

QString moved(const SentenceContext& context, int number)
{
    const auto& p = number == 1 ? context.step.segment.a : context.step.segment.b;
    return Text::tr("%1 moves along the line to %2, to %3. The part beyond that edge is removed.")
        .arg(end(number), context.edgeText(), point(p));
}

QString accepted(const SentenceContext& context)
{
    const auto& [a, b] = context.step.segment;
    const auto& line = context.tracedLine.line;
    if (a == line.a && b == line.b)
        return Text::tr("Both ends lie inside the window, so all of the line is visible.");
    if (a == b)
        return Text::tr("The line meets the window in a single point, %1: that point is visible.")
            .arg(point(a));
    return Text::tr("The remaining part, from %1 to %2, lies inside the window: it is visible.")
        .arg(point(a), point(b));
}

bool isPublished(const SentenceContext& context)
{
    return context.tracedLine.variant.form == clipping::Form::Published;
}

bool isOutside(const Point& p, const clipping::Window& w)
{
    return !(p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y);
}

} // namespace app::words
