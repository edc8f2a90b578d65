// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/narration.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/manual.h"
#include "app/teaching/sentences/polygon.h"
#include "app/teaching/teaching.h"
#include "clipping/pseudo_code.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace app {

using clipping::Step;

namespace {

Mark markOf(const Step& step, const clipping::OperationCounts& before)
{
    using clipping::What;
    struct Row {
        What what;
        Mark mark;
    };
    static constexpr std::array rows{
        Row{What::Accept, Mark::Accept}, Row{What::Reject, Mark::Reject},
        Row{What::GiveUp, Mark::GiveUp}, Row{What::Cut, Mark::Cut}, Row{What::Test, Mark::Compare}};
    if (const auto row = std::ranges::find(rows, step.what, &Row::what); row != rows.end())
        return row->mark;
    return step.cost.divisions > before.divisions       ? Mark::Divide
           : step.cost.comparisons > before.comparisons ? Mark::Compare
                                                        : Mark::Look;
}

/// The names of both ends' coordinates, from the line of the pseudo-code that accepts them.
QStringList endsIn(const QStringList& code)
{
    static const QRegularExpression accepts(
        QStringLiteral("accept the line from (\\S+), (\\S+) to (\\S+), (\\S+)$"));
    for (const QString& line : code)
        if (const auto found = accepts.match(line); found.hasMatch())
            return found.capturedTexts().sliced(1);
    return {QStringLiteral("x1"), QStringLiteral("y1"), QStringLiteral("x2"), QStringLiteral("y2")};
}

std::array<double, 4> coordinates(const clipping::Segment& s)
{
    return {s.a.x, s.a.y, s.b.x, s.b.y};
}

/// All variables after a step: the earlier ones, and those that the step assigns.
std::vector<Variable> variablesAfter(const Step& step, const QStringList& ends,
                                     const NarratedStep* before)
{
    std::vector<Variable> variables = before ? before->variables : std::vector<Variable>{};
    for (Variable& variable : variables)
        variable.before = variable.value;
    const auto put = [&](const QString& name, double value, clipping::ValueKind kind) {
        const auto known = std::ranges::find(variables, name, &Variable::name);
        if (known == variables.end())
            variables.push_back({name, value, kind});
        else
            known->value = value, known->kind = kind;
    };
    // An end that has not moved keeps the values of the trace, which may be those of a rotated
    // plane.
    const auto now = coordinates(step.segment);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!before || now[i] != coordinates(before->left)[i])
            put(ends[qsizetype(i)], now[i], clipping::ValueKind::Number);
    for (const auto& value : step.values)
        put(latin(value.name), value.value, value.kind);
    return variables;
}

std::optional<Point> candidateOf(const SentenceContext& context, const Teaching& teaching)
{
    if (teaching.parameter.empty())
        return std::nullopt;
    const auto x = context.value(teaching.middle[0]), y = context.value(teaching.middle[1]);
    if (x && y && std::isfinite(*x) && std::isfinite(*y))
        return Point{*x, *y};
    const auto t = context.value(teaching.parameter);
    if (!t || !std::isfinite(*t))
        return std::nullopt;
    const auto& [a, b] = context.tracedLine.line;
    return a + *t * (b - a);
}

NarratedStep narratedStepOf(SentenceContext context, const Teaching& teaching,
                            const std::vector<clipping::CodeLine>& code, const QStringList& ends,
                            const NarratedStep* earlier)
{
    const Step& step = context.step;
    NarratedStep narrated{.mark =
                              markOf(step, earlier ? earlier->cost : clipping::OperationCounts{}),
                          .line = clipping::lineOf(code, step.label),
                          .sentence = {},
                          .variables = variablesAfter(step, ends, earlier),
                          .left = step.segment,
                          .edge = step.edge,
                          .candidate = candidateOf(context, teaching),
                          .cost = step.cost};
    context.variables = narrated.variables;
    if (context.tracedLine.corners.empty()) {
        narrated.sentence = sentenceOf(teaching, context);
    } else {
        narrated.edge = clipping::Edge::NoEdge; // those of the bounding box
        narrated.polygonEdge = polygonEdgeOf(context);
        narrated.sentence = polygonSentence(context);
    }
    if (step.what == clipping::What::Test)
        narrated.answer = step.holds;
    return narrated;
}

} // namespace

std::optional<double> SentenceContext::value(std::string_view name) const
{
    const auto found = std::ranges::find(step.values, name, &clipping::NamedValue::name);
    return found == step.values.end() ? std::nullopt : std::optional(found->value);
}

std::optional<double> SentenceContext::known(std::string_view name) const
{
    const auto found = std::ranges::find(variables, latin(name), &Variable::name);
    return found == variables.end() ? std::nullopt : std::optional(found->value);
}

namespace {

clipping::Trace traceOf(const TracedLine& tracedLine)
{
    if (tracedLine.corners.empty())
        return functionsOf(tracedLine.variant).trace(tracedLine.line, tracedLine.window);
    return polygonUsesOf(tracedLine.variant)->trace(tracedLine.line, {tracedLine.corners});
}

} // namespace

Narration narrationOf(const TracedLine& tracedLine, Sentences sentences)
{
    const Variant& variant = tracedLine.variant;
    const std::string_view code = tracedLine.corners.empty()
                                      ? clipping::codeOf(rowOf(variant), variant.form)
                                      : polygonCode(variant);
    Narration narration{.code = shownCode(code), .refusal = refusalOf(tracedLine)};
    if (!narration.refusal.isEmpty())
        return narration;
    const clipping::Trace trace = traceOf(tracedLine);
    narration.outcome = trace.outcome;
    if (trace.outcome == clipping::Outcome::Visible)
        narration.visible = trace.visible;
    Teaching teaching = teachingOf(*variant.algorithm);
    if (sentences == Sentences::Plain)
        teaching.sentence = generalSentence;
    const auto lines = clipping::linesOf(code);
    const QStringList ends = endsIn(narration.code);
    const Step* before = nullptr;
    for (const Step& step : trace.steps) {
        const NarratedStep* earlier = narration.steps.empty() ? nullptr : &narration.steps.back();
        NarratedStep narrated =
            narratedStepOf({tracedLine, step, before}, teaching, lines, ends, earlier);
        narration.steps.push_back(std::move(narrated));
        before = &step;
    }
    return narration;
}

} // namespace app

// The words and numbers of a trace.

namespace app {

QString valueText(const Variable& variable)
{
    switch (variable.kind) {
    case clipping::ValueKind::Bits:
        return outcodeText(unsigned(variable.value));
    case clipping::ValueKind::Truth:
        return variable.value != 0 ? Text::tr("yes") : Text::tr("no");
    default:
        return exactText(variable.value);
    }
}

} // namespace app
