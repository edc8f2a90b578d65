// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/class_profile.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/experiment/one_by_one.h"

#include <algorithm>

namespace app {
namespace {

std::optional<Record> recordOf(const ExperimentOptions& scene, std::vector<clipping::Segment> lines,
                               std::span<const Variant> variants, const Follower& follower)
{
    ExperimentOptions options = scene;
    options.lines = lines.size();
    options.target = nullptr;
    if (lines.empty())
        return Record{options, {}, {}, {}};
    options.scene = repeatedScene(scene.scene.name, std::move(lines));
    auto record = recorded(options, variants, follower);
    if (record)
        record->options.scene = scene.scene; // without the lines
    return record;
}

QString shortPercentText(double share) { return QString::number(100 * share, 'g', 3); }

/// "wholly inside 0.011 %, rejected at once 64.2 % ..."
QString mixText(const ClassProfile& profile)
{
    QStringList parts;
    for (const ClassTimes& one : profile.classes)
        parts << Text::tr("%1 %2 %").arg(classText(one.of.lineClass),
                                         shortPercentText(one.of.share));
    return parts.join(QStringLiteral(", "));
}

QStringList notesOf(const ClassProfile& profile)
{
    QStringList notes{
        Text::tr("Lines of one class at a time, median nanoseconds per line. The scene is %1.")
            .arg(mixText(profile)),
        Text::tr("Weighted: the mean cost of a line of the scene, if each line cost as much "
                 "as its class does alone. In a mixed scene a line costs more, because the "
                 "processor cannot predict which class comes next.")};
    for (const ClassTimes& one : profile.classes)
        if (!one.of.standIn.isEmpty())
            notes << Text::tr("Lines of class “%1” are too rare in the scene: lines of the "
                              "scene “%2” were measured instead.")
                         .arg(classText(one.of.lineClass), one.of.standIn);
    for (const ClassTimes& one : profile.classes)
        if (const QString batches = batchText(variantsOf(one.record)); !batches.isEmpty()) {
            notes << batches;
            break;
        }
    return notes;
}

QStringList classRow(const ClassProfile& profile, std::size_t variant, const Variant& who,
                     const Measure& measure)
{
    QStringList row{QString::fromUtf8(who.algorithm->key), wordOf(who.form)};
    double weighted = 0;
    for (const auto& [of, record] : profile.classes) {
        if (record.timings.empty()) {
            row << QString();
            continue;
        }
        const double median = summaryOf(measure.times(record.timings[variant])).median;
        weighted += of.share * median;
        row << QString::number(median, 'f', 2);
    }
    return row << QString::number(weighted, 'f', 2);
}

} // namespace

std::size_t mostOfAClass(const ExperimentOptions& options)
{
    return std::size_t(std::clamp<std::uint64_t>(options.lines / 10, 1000, 100'000));
}

std::optional<ClassProfile> classProfile(const ExperimentOptions& options,
                                         std::span<const Variant> variants,
                                         const Follower& follower)
{
    ClassProfile profile{options, {}};
    // Searching for lines takes about as long as eighty turns on the lines of one class.
    std::vector weights(1 + lineClasses.size(),
                        double((options.runs + options.warmUps) * variants.size()));
    weights.front() = 80;
    PhasedProgress phases(follower, weights);
    auto all = linesByClass(options.scene, options.field, options.seed, mostOfAClass(options),
                            phases.next());
    if (!all)
        return std::nullopt;
    for (ClassLines& one : *all) {
        auto lines = std::exchange(one.lines, {});
        auto record = recordOf(options, std::move(lines), variants, phases.next());
        if (!record)
            return std::nullopt;
        profile.classes.push_back({std::move(one), std::move(*record)});
    }
    return profile;
}

Table classTable(const ClassProfile& profile)
{
    Table table{.names = {"algorithm", "form", "inside_ns", "rejected_ns", "cut_ns", "missed_ns",
                          "weighted_ns"},
                .title = Text::tr("Clipping by class of line: nanoseconds per line"),
                .key = QStringLiteral("classes"),
                .notes = notesOf(profile)};
    const auto measured = std::ranges::find_if(
        profile.classes, [](const ClassTimes& one) { return !one.record.timings.empty(); });
    if (measured == profile.classes.end())
        return table;
    table.facts = factsOf(measured->record);
    std::erase_if(table.facts, [](const auto& fact) { return fact.first == u"lines"; });
    const Measure clip = measures().front();
    for (std::size_t i = 0; i < measured->record.timings.size(); ++i)
        table.rows.push_back(classRow(profile, i, measured->record.timings[i].variant, clip));
    return table;
}

} // namespace app
