// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/random.h"
#include "app/base/text.h"
#include "app/teaching/figure_svg.h"
#include "app/teaching/trace_page_parts.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

// What the page's own interpreter needs (resources/trace_page/drag.js): the line, the window, the
// part of the drawing in the figures, and the words of its sentences.

namespace app {

namespace {

QJsonArray coordinatesOf(const Point& p, const Point& q) { return {p.x, p.y, q.x, q.y}; }

/// The kinds of the variables that are no numbers, in runs of this form that take its branches:
/// operations on them are not counted.
QJsonObject kindsOf(const TracedLine& tracedLine)
{
    constexpr int runs = 200;
    const auto& [min, max] = tracedLine.window;
    const Point half = max / 2.0 - min / 2.0;
    const clipping::Window around{min - half, max + half};
    const auto& functions = functionsOf(tracedLine.variant);
    Random random(1);
    QJsonObject kinds;
    for (int i = 0; i < runs; ++i) {
        const Point a = random.in(around);
        for (const auto& step : functions.trace({a, random.in(around)}, tracedLine.window).steps)
            for (const auto& value : step.values)
                if (value.kind != clipping::ValueKind::Number)
                    kinds[latin(value.name)] = QStringLiteral("whole");
    }
    return kinds;
}

/// A published form may be wrong, so the page only says what it returns.
QJsonObject pageWords(clipping::Form form)
{
    const bool isRight = form == clipping::Form::Corrected;
    return {
        {"end", Text::tr("End %1")},
        {"handle", Text::tr("End %1: drag it, or move it by the arrow keys")},
        {"line", Text::tr("The line from %1 to %2")},
        {"place", Text::tr("Step %1 of %2")},
        {"test", Text::tr("%1? %2: %3.")},
        {"yes", Text::tr("yes")},
        {"no", Text::tr("no")},
        {"does", Text::tr("Line %1: %2.")},
        {"now", Text::tr("Now %1.")},
        {"accept", isRight ? Text::tr("The remaining part, from %1 to %2, lies inside the window: "
                                      "it is visible.")
                           : Text::tr("The algorithm returns the part from %1 to %2.")},
        {"reject", isRight ? Text::tr("Nothing of the line is visible.")
                           : Text::tr("The algorithm returns nothing.")},
        {"moved", Text::tr("You moved an end, and the page itself runs the pseudo-code.")},
        {"back", Text::tr("Show the exported line")},
        {"variables", Text::tr("Variables")},
        {"operations", Text::tr("Operations so far")},
        {"was", Text::tr("was %1")},
        {"of", Text::tr("of %1")},
        {"comparisons", Text::tr("comparisons")},
        {"additions", Text::tr("additions")},
        {"multiplications", Text::tr("multiplications")},
        {"divisions", Text::tr("divisions")},
        {"negations", Text::tr("negations")},
    };
}

} // namespace

QByteArray dataHtml(const TraceExport& trace, const QSizeF& figureSize)
{
    const TracedLine& tracedLine = trace.tracedLine;
    if (trace.only || trace.narration.steps.empty() || !tracedLine.corners.empty())
        return {};
    const clipping::Window seen = svgFrame(tracedLine, figureSize).seen;
    const auto& visible = trace.narration.visible;
    QJsonObject data{
        {"line", coordinatesOf(tracedLine.line.a, tracedLine.line.b)},
        {"window", coordinatesOf(tracedLine.window.min, tracedLine.window.max)},
        {"y", tracedLine.y == YAxis::Up ? QStringLiteral("up") : QStringLiteral("down")},
        {"seen", coordinatesOf(seen.min, seen.max)},
        {"size", QJsonArray{figureSize.width(), figureSize.height()}},
        {"visible", visible ? QJsonValue(coordinatesOf(visible->a, visible->b)) : QJsonValue()},
        {"kinds", kindsOf(tracedLine)},
        {"words", pageWords(tracedLine.variant.form)},
    };
    QByteArray json = QJsonDocument(data).toJson(QJsonDocument::Compact);
    json.replace('<', "\\u003c"); // no word ends the script
    return "<script type=\"application/json\" id=\"trace\">" + json + "</script>\n";
}

} // namespace app
