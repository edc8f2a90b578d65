// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/trace_page_parts.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/figure_text.h"

#include <array>

namespace app {

namespace {

QByteArray escaped(const QString& text) { return text.toHtmlEscaped().toUtf8(); }

QByteArray element(const char* name, const QString& text)
{
    return QByteArray("<") + name + '>' + escaped(text) + "</" + name + '>';
}

QByteArray number(std::size_t value) { return QByteArray::number(qulonglong(value)); }

QByteArray variableRow(const Variable& variable)
{
    Variable before = variable;
    before.value = variable.before.value_or(0);
    const QString was = !variable.changed() ? QString()
                        : variable.before   ? Text::tr("was %1").arg(valueText(before))
                                            : Text::tr("new");
    return QByteArray(variable.changed() ? "<tr class=\"changed\">" : "<tr>") + "<th scope=\"row\">"
           + escaped(variable.name) + "</th>" + element("td", valueText(variable))
           + "<td class=\"was\">" + escaped(was) + "</td></tr>\n";
}

/// One kind of operation: its name, and how many there are so far and in all.
struct OperationColumn {
    QString name;
    std::uint64_t clipping::OperationCounts::*count;
};

std::array<OperationColumn, 5> operationColumns()
{
    using Counts = clipping::OperationCounts;
    return {{{Text::tr("comparisons"), &Counts::comparisons},
             {Text::tr("additions"), &Counts::additions},
             {Text::tr("multiplications"), &Counts::multiplications},
             {Text::tr("divisions"), &Counts::divisions},
             {Text::tr("negations"), &Counts::negations}}};
}

QString factsOf(const TracedLine& tracedLine)
{
    // Beyond the last step it speaks of the line and the window alone.
    return figureText(tracedLine, Narration{}, 0);
}

QString placeOf(const Narration& narration, std::size_t step)
{
    return Text::tr("Step %1 of %2").arg(step + 1).arg(narration.steps.size());
}

QByteArray button(const char* id, const QString& text, const QString& tip)
{
    return QByteArray("<button type=\"button\" id=\"") + id + "\" title=\"" + escaped(tip) + "\">"
           + escaped(text) + "</button>\n";
}

} // namespace

QByteArray paragraphHtml(const char* className, const QString& text)
{
    return text.isEmpty()
               ? QByteArray()
               : QByteArray("<p class=\"") + className + "\">" + escaped(text) + "</p>\n";
}

QByteArray variablesHtml(const NarratedStep& narrated)
{
    QByteArray html = "<table>" + element("caption", Text::tr("Variables")) + "<tbody>\n";
    for (const Variable& variable : narrated.variables)
        html += variableRow(variable);
    return html + "</tbody></table>\n";
}

QByteArray operationsHtml(const Narration& narration, std::size_t step)
{
    QByteArray html = "<table>" + element("caption", Text::tr("Operations so far")) + "<tbody>\n";
    for (const auto& [name, count] : operationColumns()) {
        const auto now = narration.steps[step].cost.*count,
                   all = narration.steps.back().cost.*count;
        if (all > 0)
            html += "<tr>" + element("td", name) + element("td", countText(now))
                    + "<td class=\"of\">" + escaped(Text::tr("of %1").arg(countText(all)))
                    + "</td></tr>\n";
    }
    return html + "</tbody></table>\n";
}

QByteArray headerHtml(const TraceExport& trace)
{
    return "<header>\n" + element("h1", titleOf(trace.tracedLine.variant)) + '\n'
           + element("p", factsOf(trace.tracedLine)) + "\n</header>\n";
}

QByteArray stepsBarHtml()
{
    return "<nav id=\"steps\" hidden>\n"
           + button("first", Text::tr("First"), Text::tr("First step (Home)"))
           + button("back", Text::tr("Back"), Text::tr("Previous step (Left)"))
           + "<span id=\"place\"></span>\n"
           + button("next", Text::tr("Next"), Text::tr("Next step (Right)"))
           + button("last", Text::tr("Last"), Text::tr("Last step (End)"))
           + "<input type=\"range\" id=\"slider\" min=\"0\" max=\"1\" value=\"0\" aria-label=\""
           + escaped(Text::tr("Step")) + "\">\n</nav>\n"
           + "<p id=\"heard\" class=\"heard\" aria-live=\"polite\"></p>\n";
}

QByteArray codeHtml(const QStringList& code)
{
    if (code.isEmpty())
        return {};
    QByteArray html =
        "<section class=\"code\">\n" + element("h2", Text::tr("Pseudo-code")) + "\n<ol>\n";
    for (const QString& line : code)
        html += element("li", line) + '\n';
    return html + "</ol>\n</section>\n";
}

QByteArray stepHtml(const TraceStep& at, const QSizeF& figureSize, std::size_t figure)
{
    const auto& [tracedLine, narration, step] = at;
    const NarratedStep& narrated = narration.steps[step];
    const QString place = placeOf(narration, step);
    const QByteArray size =
        QByteArray::number(figureSize.width()) + ' ' + QByteArray::number(figureSize.height());
    QByteArray html = "<article class=\"step\" id=\"step-" + number(step + 1) + "\" data-line=\""
                      + QByteArray::number(narrated.line) + "\" data-place=\"" + escaped(place)
                      + "\">\n" + element("h2", place) + '\n';
    html += "<svg class=\"figure\" viewBox=\"0 0 " + size + "\" role=\"img\" aria-label=\""
            + escaped(factsOf(tracedLine)) + "\"><use href=\"#f" + number(figure) + "\"/></svg>\n";
    html += paragraphHtml("sentence", narrated.sentence);
    if (narrated.line >= 1 && narrated.line <= narration.code.size())
        html += "<p class=\"line\">" + escaped(Text::tr("Line %1: ").arg(narrated.line)) + "<code>"
                + escaped(narration.code[narrated.line - 1].trimmed()) + "</code></p>\n";
    return html + "<div class=\"values\">\n" + variablesHtml(narrated)
           + operationsHtml(narration, step) + "</div>\n</article>\n";
}

QString leftOutText(std::size_t from, std::size_t to)
{
    return Text::tr("Steps %1 to %2 are not on this page, so that it stays below 300 kB. "
                    "`clearcut trace` prints all of them as text.")
        .arg(countText(from + 1), countText(to + 1));
}

} // namespace app
