// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/process_runs.h"

#include "app/base/number.h"
#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/comparison/variants.h"
#include "app/experiment/circumstances.h"
#include "app/report/repeat.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

namespace app {
namespace {

QString keyOf(const std::optional<PaperTable>& paper) { return paper ? paper->key : QString(); }

/// A timing of one run. It names its table, variant and number of lines, by which it is found
/// again: the plan of the other process may list the variants in another order.
QJsonObject jsonOf(const Trial& trial, const Timing& timing)
{
    const auto whole = [](std::uint64_t number) { return QString::number(number); };
    return {{"paper", keyOf(trial.paper)},          {"variant", keyOf(timing.variant)},
            {"target", trial.record.target},        {"lines", whole(trial.record.options.lines)},
            {"generate", timing.generate.front()},  {"clip", timing.clip.front()},
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

/// The JSON of one run; empty if it was stopped.
Result<QJsonArray> measuredRun(const RunProgram& program, std::size_t run, const Follower& follower)
{
    constexpr int untilNextLook = 50; // milliseconds
    QProcess process;
    process.start(program.path,
                  program.words + QStringList{QStringLiteral("--one-run=%1").arg(run)});
    process.closeWriteChannel();
    while (process.state() != QProcess::NotRunning && !process.waitForFinished(untilNextLook))
        if (follower.stop.stop_requested()) {
            process.kill();
            process.waitForFinished(-1);
            return Result<QJsonArray>::of({});
        }
    const QJsonArray timings = QJsonDocument::fromJson(process.readAllStandardOutput()).array();
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0
        && !timings.isEmpty())
        return Result<QJsonArray>::of(timings);
    const QString said = process.error() == QProcess::FailedToStart
                             ? process.errorString()
                             : QString::fromUtf8(process.readAllStandardError()).trimmed();
    return Result<QJsonArray>::failure(
        Text::tr("The process of run %1 failed. %2").arg(run + 1).arg(said));
}

/// Adds a run to the records of a plan. False if it lacks one of the timings.
bool addRun(const Plan& plan, std::vector<Record>& records, const QJsonArray& run)
{
    for (std::size_t i = 0; i < records.size(); ++i)
        for (Timing& timing : records[i].timings) {
            const QString paper = keyOf(plan.trials[i].paper), variant = keyOf(timing.variant);
            const auto found = std::ranges::find_if(run, [&](const QJsonValue& one) {
                return one[QLatin1StringView("paper")] == paper
                       && one[QLatin1StringView("variant")] == variant;
            });
            const QString lines = QString::number(plan.trials[i].options.lines);
            if (found == run.end() || (*found)[QLatin1StringView("lines")] != lines)
                return false;
            records[i].target = (*found)[QLatin1StringView("target")].toString();
            addRun(timing, found->toObject());
        }
    return true;
}

/// Writes the lines of a scene as coordinates, x1,y1,x2,y2, a row for each; ends if it is stopped.
void writeLines(QIODevice& out, const TestScene& scene, const Field& field,
                const std::stop_token& stop)
{
    constexpr std::uint64_t atOnce = 10'000;
    std::vector<clipping::Segment> lines;
    std::string rows;
    const LineSource next = scene.begin(field, 0);
    for (std::uint64_t left = scene.lines; left > 0 && !stop.stop_requested();
         left -= lines.size()) {
        lines.resize(std::min(left, atOnce));
        next(lines);
        rows.clear();
        for (const auto& [a, b] : lines) {
            std::string_view before;
            for (const double number : {a.x, a.y, b.x, b.y}) {
                rows += before;
                appendNumber(rows, number);
                before = ",";
            }
            rows += '\n';
        }
        writeAll(out, rows);
    }
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

QByteArray dataOfRun(const Study& study)
{
    QJsonArray timings;
    for (const Trial& trial : study.trials)
        for (const Timing& timing : trial.record.timings)
            timings.append(jsonOf(trial, timing));
    return QJsonDocument(timings).toJson(QJsonDocument::Compact);
}

namespace {

/// The words that describe a plan. The lines of a drawing are in a file, in `folder`. What draws is
/// left to the other program: the best that works, as in a Choice.
Result<QStringList> wordsFor(const Plan& plan, const QString& folder, const std::stop_token& stop)
{
    Study study{plan.measures, {}};
    std::vector<Record> records = emptyRecords(plan);
    for (std::size_t i = 0; i < records.size(); ++i)
        study.trials.push_back({plan.trials[i].paper, std::move(records[i])});
    for (Trial& trial : study.trials) {
        TestScene& scene = trial.record.options.scene;
        if (scene.lines == 0)
            continue;
        const QString path = QDir(folder).filePath(QStringLiteral("lines.csv"));
        if (const auto error = replaceFile(path, [&](QIODevice& out) {
                writeLines(out, scene, trial.record.options.field, stop);
                return std::optional<QString>();
            }))
            return Result<QStringList>::failure(*error);
        scene.name = path;
    }
    return Result<QStringList>::of(wordsToRepeat(study));
}

} // namespace

Result<std::vector<Record>> recordsInProcesses(const Plan& plan, const RunProgram& program,
                                               const Follower& follower)
{
    using Records = Result<std::vector<Record>>;
    std::vector<Record> records = emptyRecords(plan);
    const std::size_t runs = plan.trials.empty() ? 0 : plan.trials.front().options.runs;
    TurnProgress turns(follower, double(runs));
    for (std::size_t run = 0; run < runs; ++run) {
        if (turns.stopped())
            return Records::of({});
        const auto timings = measuredRun(program, run, follower);
        if (!timings)
            return Records::failure(timings.error);
        if (timings.value->isEmpty())
            return Records::of({});
        if (!addRun(plan, records, *timings.value))
            return Records::failure(
                Text::tr("The process of run %1 measured something else.").arg(run + 1));
        turns.turnDone();
    }
    return Records::of(std::move(records));
}

Result<Study> studyInProcesses(const Plan& plan, const QString& program, const Follower& follower)
{
    const QTemporaryDir folder;
    if (!folder.isValid())
        return Result<Study>::failure(
            Text::tr("No folder for temporary files could be made: %1").arg(folder.errorString()));
    auto words = wordsFor(plan, folder.path(), follower.stop);
    if (!words)
        return Result<Study>::failure(words.error);
    Plan times = plan;
    times.explained.reset();
    const double timing = roughSeconds(times);
    PhasedProgress phases(follower, {timing, roughSeconds(plan) - timing});
    auto records = recordsInProcesses(plan, {program, *words.value}, phases.next());
    if (!records || records.value->empty())
        return Result<Study>::failure(records.error);
    return {study(plan, std::move(*records.value), phases.next()), {}};
}

} // namespace app
