// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/record.h"

#include "app/experiment/circumstances.h"
#include "app/formats/number.h"
#include "app/latin.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

struct Experiments {
    Q_DECLARE_TR_FUNCTIONS(Experiments)
};

QString inNanoseconds(double time) { return QString::number(time, 'f', 2); }

/// No time is below 0; one run says nothing of where the middle lies.
QString bound(double time)
{
    return std::isfinite(time) ? inNanoseconds(std::max(time, 0.0)) : QString();
}

QString hexadecimal(std::uint64_t checksum)
{
    return QStringLiteral("%1").arg(checksum, 16, 16, QLatin1Char('0'));
}

/// "OpenGL 4.5, llvmpipe; wall clock"
QString easelText(const ExperimentOptions& options, const Easel& easel)
{
    const Clock clock = drawClock(options, easel);
    return clock.name == options.clock.name
               ? easel.name()
               : easel.name() + QStringLiteral("; clock: ") + clock.name;
}

bool hasTies(const std::vector<Standing>& all)
{
    return std::ranges::any_of(all, [](const Standing& standing) { return !standing.rank; });
}

QStringList rowOf(const Timing& timing, const Summary& times, const Standing& standing)
{
    return {QString::fromUtf8(timing.contestant.algorithm->key),
            wordOf(timing.contestant.form),
            placeText(standing),
            inNanoseconds(times.median),
            inNanoseconds(times.spread),
            inNanoseconds(times.mean),
            bound(times.confidence.low),
            bound(times.confidence.high),
            QString::number(timing.found.visible),
            QString::number(timing.found.lost),
            QString::number(timing.found.shown),
            hexadecimal(timing.found.checksum)};
}

} // namespace

std::optional<Record> recorded(const ExperimentOptions& options,
                               std::span<const Contestant> contestants, const Follower& follower)
{
    ExperimentOptions asked = options;
    QString drew; // what drew indeed, which may be another than was asked for
    if (options.easel)
        asked.easel = [&](const Field& field) {
            auto easel = options.easel(field);
            drew = easelText(options, *easel);
            return easel;
        };
    auto timings = experiment(asked, contestants, follower);
    if (!timings)
        return std::nullopt;
    asked.easel = nullptr; // a record draws no more
    return Record{std::move(asked), drew, circumstances(), std::move(*timings)};
}

std::vector<Summary> summaries(const Record& record, const Measure& measure)
{
    std::vector<Summary> all;
    for (const Timing& timing : record.timings)
        all.push_back(summaryOf(measure.times(timing)));
    return all;
}

QString rectangleText(const clipping::Window& window)
{
    std::string text;
    for (const double number : {window.min.x, window.min.y, window.max.x, window.max.y}) {
        if (!text.empty())
            text += ',';
        appendNumber(text, number);
    }
    return QString::fromStdString(text);
}

QString tieLetter(std::size_t group)
{
    const QString last(QChar(u'a' + char16_t(group % 26)));
    return group < 26 ? last : tieLetter(group / 26 - 1) + last;
}

QString placeText(const Standing& standing)
{
    if (standing.rank)
        return QString::number(*standing.rank);
    QStringList letters;
    for (const int tie : standing.ties)
        letters << tieLetter(std::size_t(tie));
    return Experiments::tr("tie %1").arg(letters.join(u' '));
}

std::vector<std::pair<QString, QString>> factsOf(const ExperimentOptions& options)
{
    return {
        {"scene", options.scene.key},
        {"lines", QString::number(options.lines)},
        {"seed", QString::number(options.seed)},
        {"space", rectangleText(options.field.space)},
        {"window", rectangleText(options.field.window)},
    };
}

std::vector<std::pair<QString, QString>> factsOf(const Record& record)
{
    const ExperimentOptions& options = record.options;
    auto facts = factsOf(options);
    facts.emplace_back("order", latin(nameOf(options.order).words));
    facts.emplace_back("precision", wordOf(options.precision));
    facts.emplace_back("threads", QString::number(options.threads));
    facts.emplace_back("runs", QString::number(options.runs));
    facts.emplace_back("warmup", QString::number(options.warmUps));
    facts.emplace_back("clock", options.clock.name);
    if (!record.easel.isEmpty())
        facts.emplace_back("drawn", record.easel);
    facts.insert(facts.end(), record.circumstances.begin(), record.circumstances.end());
    return facts;
}

Table timesTable(const Record& record, const Measure& measure)
{
    Table table{.names = {"algorithm", "form", "rank", "median_ns", "spread_ns", "mean_ns",
                          "low_ns", "high_ns", "visible", "lost", "shown", "checksum"},
                .title = Experiments::tr("%1: nanoseconds a line").arg(measure.name),
                .key = measure.key,
                .facts = factsOf(record),
                .notes = {measure.meaning}};
    const auto times = summaries(record, measure);
    const auto places = standings(times);
    for (std::size_t i = 0; i < times.size(); ++i)
        table.rows.push_back(rowOf(record.timings[i], times[i], places[i]));
    table.notes << Experiments::tr(
        "From low to high: where the middle lies with 95 % confidence. Lost: lines that are "
        "visible and that it drops; shown: lines that are not and that it keeps.");
    if (record.options.precision == Precision::Single)
        table.notes << Experiments::tr("In single precision ends are some ulps apart, and so who "
                                       "agrees may still have another "
                                       "checksum.");
    if (hasTies(places))
        table.notes << Experiments::tr("Ties that share a letter are too close to call: their "
                                       "intervals overlap. Who shares none "
                                       "with another differs from it.");
    return table;
}

Table runsTable(const Record& record, std::span<const Measure> measures)
{
    Table table{.names = {"algorithm", "form", "measure", "run", "lines", "visible", "seconds"},
                .title = Experiments::tr("Every run"),
                .key = QStringLiteral("runs"),
                .facts = factsOf(record)};
    std::erase_if(table.facts, [](const auto& fact) { return fact.first == u"lines"; });
    for (const Measure& measure : measures)
        for (const Timing& timing : record.timings) {
            int run = 0;
            for (const double time : measure.times(timing))
                table.rows.push_back(
                    {QString::fromUtf8(timing.contestant.algorithm->key),
                     wordOf(timing.contestant.form), measure.key, QString::number(++run),
                     QString::number(record.options.lines), QString::number(timing.found.visible),
                     QString::number(time * double(record.options.lines) * 1e-9, 'f', 9)});
        }
    return table;
}

} // namespace app
