// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/base/text.h"
#include "app/teaching/trace_file.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <array>
#include <cmath>

// A trace as data: everything that the library reports, in reading order. README.md of this folder
// describes the format.

namespace app {

namespace {

/// A number as in all files of the program; NaN and infinity as words.
QString jsonNumber(double value)
{
    if (std::isnan(value))
        return QStringLiteral("\"nan\"");
    if (std::isinf(value))
        return value > 0 ? QStringLiteral("\"inf\"") : QStringLiteral("\"-inf\"");
    return shortestText(value);
}

QString quoted(const QString& text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

QString list(const QStringList& parts) { return u'[' + parts.join(QStringLiteral(", ")) + u']'; }

QString list(const clipping::Segment& s)
{
    return list(
        QStringList{jsonNumber(s.a.x), jsonNumber(s.a.y), jsonNumber(s.b.x), jsonNumber(s.b.y)});
}

/// {"name": value, ...} in the given order.
QString object(const std::vector<std::pair<const char*, QString>>& fields, const QString& indent)
{
    QStringList lines;
    for (const auto& [name, value] : fields)
        lines << indent + QStringLiteral("  \"%1\": ").arg(QLatin1StringView(name)) + value;
    return QStringLiteral("{\n") + lines.join(QStringLiteral(",\n")) + u'\n' + indent + u'}';
}

QString edgeKey(clipping::Edge edge)
{
    static constexpr std::array<const char*, 5> names{"null", "\"xmin\"", "\"xmax\"", "\"ymin\"",
                                                      "\"ymax\""};
    const auto at = std::size_t(edge);
    return QLatin1StringView(at < names.size() ? names[at] : names[0]);
}

QString markKey(Mark mark)
{
    static constexpr std::array<const char*, 7> names{"look",   "compare", "divide", "cut",
                                                      "accept", "reject",  "give up"};
    return quoted(QLatin1StringView(names[std::size_t(mark)]));
}

QString kindKey(clipping::ValueKind kind)
{
    static constexpr std::array<const char*, 4> names{"number", "whole", "bits", "truth"};
    return quoted(QLatin1StringView(names[std::size_t(kind)]));
}

QString valueOf(double value, clipping::ValueKind kind)
{
    if (kind == clipping::ValueKind::Truth)
        return value != 0 ? QStringLiteral("true") : QStringLiteral("false");
    return jsonNumber(value);
}

QString variablesOf(const NarratedStep& narrated)
{
    QStringList lines;
    for (const Variable& v : narrated.variables)
        lines << QStringLiteral(
                     "        {\"name\": %1, \"kind\": %2, \"value\": %3, \"before\": %4}")
                     .arg(quoted(v.name), kindKey(v.kind), valueOf(v.value, v.kind),
                          v.before ? valueOf(*v.before, v.kind) : QStringLiteral("null"));
    return QStringLiteral("[\n") + lines.join(QStringLiteral(",\n")) + QStringLiteral("\n      ]");
}

QString operationsOf(const clipping::OperationCounts& cost)
{
    return QStringLiteral("{\"comparisons\": %1, \"additions\": %2, \"multiplications\": %3, "
                          "\"divisions\": %4, \"negations\": %5}")
        .arg(cost.comparisons)
        .arg(cost.additions)
        .arg(cost.multiplications)
        .arg(cost.divisions)
        .arg(cost.negations);
}

QString stepOf(const NarratedStep& narrated, std::size_t step)
{
    const auto& candidate = narrated.candidate;
    const auto truth = [](bool is) {
        return is ? QStringLiteral("true") : QStringLiteral("false");
    };
    return QStringLiteral("    ")
           + object(
               {{"step", QString::number(step + 1)},
                {"line",
                 narrated.line > 0 ? QString::number(narrated.line) : QStringLiteral("null")},
                {"mark", markKey(narrated.mark)},
                {"sentence", quoted(narrated.sentence)},
                {"answer", narrated.answer ? truth(*narrated.answer) : QStringLiteral("null")},
                {"edge", narrated.polygonEdge ? QString::number(narrated.polygonEdge)
                                              : edgeKey(narrated.edge)},
                {"left", list(narrated.left)},
                {"candidate", candidate ? list({jsonNumber(candidate->x), jsonNumber(candidate->y)})
                                        : QStringLiteral("null")},
                {"variables", variablesOf(narrated)},
                {"operations", operationsOf(narrated.cost)}},
               QStringLiteral("    "));
}

QString outcomeKey(clipping::Outcome outcome)
{
    static constexpr std::array<const char*, 3> names{"visible", "invisible", "did not end"};
    return quoted(QLatin1StringView(names[std::size_t(outcome)]));
}

QString stepsOf(const TraceExport& trace, std::span<const std::size_t> steps)
{
    QStringList lines;
    for (const std::size_t step : steps)
        if (step < trace.narration.steps.size())
            lines << stepOf(trace.narration.steps[step], step);
    return QStringLiteral("[\n") + lines.join(QStringLiteral(",\n")) + QStringLiteral("\n  ]");
}

/// The bounding box, and the corners of a window that is not a rectangle.
QString windowOf(const TracedLine& tracedLine)
{
    const QString box = list(clipping::Segment{tracedLine.window.min, tracedLine.window.max});
    QStringList corners;
    for (const Point& corner : tracedLine.corners)
        corners << list({jsonNumber(corner.x), jsonNumber(corner.y)});
    return corners.isEmpty() ? box : box + QStringLiteral(",\n  \"corners\": ") + list(corners);
}

} // namespace

QByteArray traceJson(const TraceExport& trace, std::span<const std::size_t> steps)
{
    const Narration& narration = trace.narration;
    const TracedLine& tracedLine = trace.tracedLine;
    const Variant& variant = tracedLine.variant;
    QStringList code;
    for (const QString& text : narration.code)
        code << quoted(text);
    const QString text = object(
        {{"format", quoted(QStringLiteral("clearcut-trace-1"))},
         {"algorithm",
          quoted(variant.misprint ? variant.misprint->key : latin(variant.algorithm->key))},
         {"form", quoted(variant.form == clipping::Form::Published ? QStringLiteral("published")
                                                                   : QStringLiteral("corrected"))},
         {"line", list(tracedLine.line)},
         {"window", windowOf(tracedLine)},
         {"y", quoted(tracedLine.y == YAxis::Up ? QStringLiteral("up") : QStringLiteral("down"))},
         {"outcome", outcomeKey(narration.outcome)},
         {"visible", narration.visible ? list(*narration.visible) : QStringLiteral("null")},
         {"code", list(code)},
         {"steps", stepsOf(trace, steps)}},
        {});
    return (text + u'\n').toUtf8();
}

} // namespace app
