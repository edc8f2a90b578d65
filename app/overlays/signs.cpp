// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/overlays/corner_signs.h"
#include "app/overlays/parts.h"

namespace app {

namespace {

/// The corners whose bits are set lie to the left of the line, if y points up. Empty if the
/// outcodes decided before the test.
std::optional<unsigned> patternOf(const clipping::Trace& trace)
{
    std::optional<unsigned> pattern; // the last value: a doubtful pattern is tested again
    for (const clipping::Step& step : trace.steps)
        for (const clipping::NamedValue& value : step.values)
            if (value.name == "c")
                pattern = unsigned(value.value);
    return pattern;
}

QString bitsOf(unsigned pattern)
{
    return QStringLiteral("%1").arg(pattern, 4, 2, QLatin1Char('0'));
}

/// Whether two opposite corners have one sign and the other two the opposite sign, which no line
/// gives.
constexpr bool isImpossible(unsigned pattern) { return pattern == 5 || pattern == 10; }

/// The edges whose corners have different signs, and which are therefore crossed.
QString crossedBy(unsigned pattern, YAxis y)
{
    if (isImpossible(pattern))
        return Text::tr("impossible");
    QStringList crossed;
    for (const clipping::Edge edge : crossedEdges(pattern))
        crossed << edgeName(edge, y);
    return crossed.isEmpty() ? Text::tr("none") : crossed.join(Text::tr(", "));
}

OverlayTable signsTable(std::optional<unsigned> pattern, YAxis y)
{
    OverlayTable table{{Text::tr("c"), Text::tr("signs"), Text::tr("crosses")}, {}, pattern};
    for (unsigned c = 0; c < 16; ++c)
        table.rows.push_back({QString::number(c), bitsOf(c), crossedBy(c, y)});
    return table;
}

void addCorners(Overlay& overlay, unsigned pattern, const clipping::Window& window)
{
    const auto& [min, max] = window;
    const std::array<Point, 4> corners{min, {max.x, min.y}, max, {min.x, max.y}};
    using Symbol = OverlayMark::Symbol;
    for (unsigned k = 0; k < 4; ++k) {
        const bool left = pattern >> k & 1U;
        overlay.marks.push_back(
            {.at = corners[k],
             .symbol = left ? Symbol::Plus : Symbol::Minus,
             .label = QStringLiteral("x%1  %2").arg(k).arg(QChar(left ? u'+' : u'\u2212')),
             .emphasis = Emphasis::Highlighted});
    }
}

/// The infinite line, whose side is tested for the corners.
std::optional<OverlayLine> infiniteLine(const OverlayContext& context)
{
    const auto& [a, b] = *context.line;
    const auto part = clipping::findAlgorithm("liang-barsky")->line->clip({a, b}, context.seen);
    if (!part)
        return std::nullopt;
    return OverlayLine{.segment = *part, .kind = OverlayLine::Kind::Ray};
}

QString signsCaption(const OverlayContext& context, std::optional<unsigned> pattern)
{
    if (!context.line)
        return Text::tr(
                   "The outcodes are tested first, then the side of the line on which each corner "
                   "of the window lies. %1")
            .arg(pointAtALine());
    if (!pattern)
        return Text::tr("%1 No corner had to be tested.").arg(codeWords(context));
    const QString signs = Text::tr("The corners' signs make c = %1 (%2), row %1 of the table: ")
                              .arg(*pattern)
                              .arg(bitsOf(*pattern));
    return signs
           + (crossedBy(*pattern, context.y) == crossedBy(0, context.y)
                  ? Text::tr("all corners lie on one side of the line, so nothing is visible.")
                  : Text::tr("the line crosses %1.").arg(crossedBy(*pattern, context.y)));
}

} // namespace

Overlay signOverlay(const OverlayContext& context)
{
    Overlay overlay{.areas = outcodeRegions(context), .lines = regionBorders(context)};
    std::optional<unsigned> pattern;
    if (context.line) {
        pattern = patternOf(context.trace);
        if (const auto line = infiniteLine(context))
            overlay.lines.push_back(*line);
        if (pattern)
            addCorners(overlay, *pattern, context.window);
        const auto [a, b] = codesOf(context);
        for (OverlayMark& mark : endMarks(*context.line, outcodeText(a), outcodeText(b)))
            overlay.marks.push_back(std::move(mark));
    }
    overlay.table = signsTable(pattern, context.y);
    overlay.caption = signsCaption(context, pattern);
    return overlay;
}

} // namespace app
