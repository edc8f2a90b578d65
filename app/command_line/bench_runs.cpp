// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_runs.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/experiment/circumstances.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace app {
namespace {

/// The numbers of a timing, with the types of their vectors.
QJsonObject jsonOf(const Timing& timing)
{
    const auto whole = [](std::uint64_t number) { return QString::number(number); };
    return {{"generate", timing.generate.front()},  {"clip", timing.clip.front()},
            {"draw", timing.draw.front()},          {"visible", whole(timing.visible.front())},
            {"lost", whole(timing.found.lost)},     {"shown", whole(timing.found.shown)},
            {"found", whole(timing.found.visible)}, {"checksum", whole(timing.found.checksum)},
            {"pixels", whole(timing.pixels)}};
}

/// Adds a run to a timing; the first one provides the findings.
void addRun(Timing& timing, const QJsonObject& run)
{
    const auto whole = [&](const char* name) {
        return run[QLatin1StringView(name)].toString().toULongLong();
    };
    if (timing.clip.empty()) {
        timing.found = {whole("found"), whole("lost"), whole("shown"), whole("checksum")};
        timing.pixels = whole("pixels");
    }
    timing.generate.push_back(run[QLatin1StringView("generate")].toDouble());
    timing.clip.push_back(run[QLatin1StringView("clip")].toDouble());
    timing.draw.push_back(run[QLatin1StringView("draw")].toDouble());
    timing.visible.push_back(whole("visible"));
}

std::vector<Record> emptyRecords(const Plan& plan)
{
    std::vector<Record> records;
    for (const PlannedTrial& trial : plan.trials) {
        Record record{trial.options, {}, circumstances(), {}};
        record.options.target = nullptr; // a record does not draw any more
        for (const Variant& variant : trial.variants)
            record.timings.push_back({.variant = variant, .generate = {}, .clip = {}, .draw = {}});
        records.push_back(std::move(record));
    }
    return records;
}

/// The JSON of one run, measured by this program.
QJsonArray measuredRun(std::size_t run)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::SeparateChannels);
    process.start(QCoreApplication::applicationFilePath(),
                  QCoreApplication::arguments().sliced(1)
                      + QStringList{QStringLiteral("--one-run"), QString::number(run)});
    process.closeWriteChannel();
    process.waitForFinished(-1);
    const QJsonArray trials = QJsonDocument::fromJson(process.readAllStandardOutput()).array();
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0
        && !trials.isEmpty())
        return trials;
    const QString said = QString::fromUtf8(process.readAllStandardError()).trimmed();
    throw Failure{Text::tr("The process of run %1 failed. %2").arg(run + 1).arg(said)};
}

} // namespace

Plan planOfRun(Plan plan, std::size_t run)
{
    for (PlannedTrial& trial : plan.trials) {
        trial.options.runs = 1;
        trial.options.firstRun = run;
    }
    plan.explained.reset();
    return plan;
}

void printRun(const Study& study)
{
    QJsonArray trials;
    for (const Trial& trial : study.trials) {
        QJsonArray timings;
        for (const Timing& timing : trial.record.timings)
            timings.append(jsonOf(timing));
        trials.append(QJsonObject{{"target", trial.record.target}, {"timings", timings}});
    }
    print(QString::fromUtf8(QJsonDocument(trials).toJson(QJsonDocument::Compact)));
}

std::vector<Record> recordsInProcesses(const Plan& plan, const Follower& follower)
{
    std::vector<Record> records = emptyRecords(plan);
    const std::size_t runs = plan.trials.empty() ? 0 : plan.trials.front().options.runs;
    TurnProgress turns(follower, double(runs));
    for (std::size_t run = 0; run < runs; ++run) {
        const QJsonArray trials = measuredRun(run);
        for (std::size_t i = 0; i < records.size(); ++i) {
            const QJsonObject trial = trials[qsizetype(i)].toObject();
            const QJsonArray timings = trial[QLatin1StringView("timings")].toArray();
            records[i].target = trial[QLatin1StringView("target")].toString();
            for (std::size_t k = 0; k < records[i].timings.size(); ++k)
                addRun(records[i].timings[k], timings[qsizetype(k)].toObject());
        }
        turns.turnDone();
    }
    return records;
}

} // namespace app
