// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/figure_marks.h"
#include "app/teaching/trace_file.h"

// A trace as text for a terminal.

namespace app {

namespace {

QString pair(const Point& point)
{
    return QStringLiteral("%1, %2").arg(exactText(point.x), exactText(point.y));
}

/// The changes of a step: "x1 = −100 (was −160), t = 0.26".
QString changes(const NarratedStep& narrated)
{
    QStringList words;
    for (const Variable& variable : narrated.variables) {
        if (!variable.changed())
            continue;
        QString word = QStringLiteral("%1 = %2").arg(variable.name, valueText(variable));
        if (variable.before) {
            Variable before = variable;
            before.value = *variable.before;
            word += Text::tr(" (was %1)").arg(valueText(before));
        }
        words << word;
    }
    return words.join(QStringLiteral(", "));
}

QString operations(const clipping::OperationCounts& cost)
{
    return Text::tr("comparisons %1, additions %2, multiplications %3, divisions %4")
        .arg(cost.comparisons)
        .arg(cost.additions)
        .arg(cost.multiplications)
        .arg(cost.divisions);
}

QString traceStepText(const TraceExport& trace, std::size_t step)
{
    const Narration& narration = trace.narration;
    const NarratedStep& narrated = narration.steps[step];
    const QString indent(5, u' ');
    QString text = QString::number(step + 1).rightJustified(3) + QStringLiteral("  ")
                   + narrated.sentence + u'\n';
    if (narrated.line >= 1 && narrated.line <= narration.code.size())
        text += indent + Text::tr("line %1: ").arg(narrated.line)
                + narration.code[narrated.line - 1].trimmed() + u'\n';
    if (const QString changed = changes(narrated); !changed.isEmpty())
        text += indent + changed + u'\n';
    return text + indent + operations(narrated.cost) + u'\n';
}

QString endText(const Narration& narration)
{
    if (narration.visible)
        return Text::tr("Visible: %1 to %2")
            .arg(pair(narration.visible->a), pair(narration.visible->b));
    return narration.outcome == clipping::Outcome::DidNotEnd
               ? Text::tr("The algorithm did not end and was stopped: nothing is visible.")
               : Text::tr("Nothing is visible.");
}

QString windowText(const TracedLine& tracedLine)
{
    const QString y = tracedLine.y == YAxis::Up ? Text::tr("up") : Text::tr("down");
    if (tracedLine.corners.empty())
        return (tracedLine.windowIsPage ? Text::tr("Page:    %1 to %2, y grows %3\n\n")
                                        : Text::tr("Window:  %1 to %2, y grows %3\n\n"))
            .arg(pair(tracedLine.window.min), pair(tracedLine.window.max), y);
    QStringList corners;
    for (const Point& corner : tracedLine.corners)
        corners << pair(corner);
    return Text::tr("Window:  %1; edge 1 begins at the first corner, y grows %2\n\n")
        .arg(corners.join(QStringLiteral("; ")), y);
}

} // namespace

QByteArray traceText(const TraceExport& trace, std::span<const std::size_t> steps)
{
    const TracedLine& tracedLine = trace.tracedLine;
    QString text = titleOf(tracedLine.variant) + u'\n';
    text += Text::tr("Line:    %1 to %2\n").arg(pair(tracedLine.line.a), pair(tracedLine.line.b));
    text += windowText(tracedLine);
    if (trace.narration.steps.empty())
        return (text + trace.narration.refusal + u'\n').toUtf8();
    for (const std::size_t step : steps)
        text += traceStepText(trace, step) + u'\n';
    return (text + endText(trace.narration) + u'\n').toUtf8();
}

} // namespace app
