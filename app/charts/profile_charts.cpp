// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/charts/record_chart.h"
#include "app/charts/words.h"
#include "app/experiment/one_by_one.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

using clipping::OperationCounts;

/// One kind of operation, in the order of a bar's parts.
struct Kind {
    const char* name;
    std::uint64_t OperationCounts::*count;
};
constexpr std::array kinds{
    Kind{QT_TRANSLATE_NOOP("Text", "comparisons"), &OperationCounts::comparisons},
    Kind{QT_TRANSLATE_NOOP("Text", "additions"), &OperationCounts::additions},
    Kind{QT_TRANSLATE_NOOP("Text", "multiplications"), &OperationCounts::multiplications},
    Kind{QT_TRANSLATE_NOOP("Text", "divisions"), &OperationCounts::divisions},
};

ChartRow operationsRow(const VariantOperations& operations, std::uint64_t lines)
{
    ChartRow row = rowFor(operations.variant);
    const OperationCounts scene = operations.scene();
    QStringList detail{fullName(operations.variant)};
    Bar bar;
    for (const Kind& kind : kinds) {
        bar.parts.push_back(double(scene.*kind.count) / double(lines));
        detail
            << Text::tr("%1 %2 per line").arg(numberText(bar.parts.back(), 2), Text::tr(kind.name));
    }
    detail << Text::tr("not counted: %1 negations per line")
                  .arg(numberText(double(scene.negations) / double(lines), 2));
    row.numbers = {numberText(bar.length(), 1)};
    row.detail = detail.join(u'\n');
    row.figures = {std::move(bar)};
    return row;
}

double lengthOf(const ChartRow& row) { return std::get<Bar>(row.figures.front()).length(); }

/// The row of one variant: a bar for each class, and the weighted cost of a line of the scene.
struct ClassRow {
    ChartRow row;
    double weighted = 0;
};

void add(ClassRow& so, const ClassTimes& one, std::size_t variant, const Measure& measure)
{
    const QString name = classText(one.of.lineClass);
    if (one.record.timings.empty()) {
        so.row.figures.push_back({});
        so.row.detail += u'\n' + Text::tr("%1: none in this scene").arg(name);
        return;
    }
    const Summary times = summaryOf(measure.times(one.record.timings[variant]));
    so.weighted += one.of.share * times.median;
    so.row.figures.push_back(Bar{{times.median}, {}, numberText(times.median, 1)});
    so.row.detail += u'\n' + QStringLiteral("%1: %2").arg(name, nanosecondsText(times.median));
}

std::vector<Variant> variantsOf(const ClassProfile& profile)
{
    std::vector<Variant> all;
    const auto measured = std::ranges::find_if(
        profile.classes, [](const ClassTimes& one) { return !one.record.timings.empty(); });
    if (measured != profile.classes.end())
        for (const Timing& timing : measured->record.timings)
            all.push_back(timing.variant);
    return all;
}

QStringList notesOf(const ClassProfile& profile)
{
    QStringList notes(Text::tr("Weighted: the mean cost of a line of the scene, if each line "
                               "cost as much as its class does alone."));
    for (const ClassTimes& one : profile.classes)
        if (!one.of.standIn.isEmpty())
            notes << Text::tr("Lines of class “%1” are too rare in the scene: lines of the scene "
                              "“%2” were measured instead.")
                         .arg(classText(one.of.lineClass), one.of.standIn);
    if (const QString batches = batchText(variantsOf(profile)); !batches.isEmpty())
        notes << batches;
    return notes;
}

} // namespace

Chart chartOf(const OperationProfile& profile)
{
    Chart chart{
        .key = QStringLiteral("%1-operations").arg(profile.options.scene.key),
        .title = Text::tr("Operations per line"),
        .subtitle = sceneText(profile.options),
        .panels = {{{}, Text::tr("operations per line")}},
        .columns = {Text::tr("all")},
        .rows = {},
        .notes = {Text::tr(
            "Additions include subtractions. Negations and operations on bits are not counted.")}};
    for (std::size_t k = 0; k < kinds.size(); ++k)
        chart.legend.push_back({LegendBar{k}, Text::tr(kinds[k].name)});
    for (const VariantOperations& operations : profile.rows)
        chart.rows.push_back(operationsRow(operations, profile.options.lines));
    std::ranges::stable_sort(chart.rows, {}, lengthOf);
    return withSharedNote(std::move(chart));
}

Chart chartOf(const ClassProfile& profile)
{
    Chart chart{
        .key = QStringLiteral("%1-classes").arg(profile.options.scene.key),
        .title = Text::tr("Nanoseconds per line, by class of line"),
        .subtitle =
            Text::tr("Scene “%1”: the share of each class of line, and its cost when clipped alone")
                .arg(profile.options.scene.name),
        .panels = {},
        .columns = {Text::tr("weighted")},
        .rows = {},
        .notes = notesOf(profile)};
    for (const ClassTimes& one : profile.classes)
        chart.panels.push_back({classText(one.of.lineClass) + u'\n' + percentText(one.of.share),
                                Text::tr("nanoseconds per line")});
    const Measure clip = measures().front();
    std::vector<ClassRow> rows;
    for (const Variant& variant : variantsOf(profile)) {
        ClassRow so{rowFor(variant)};
        so.row.detail = fullName(variant);
        for (const ClassTimes& one : profile.classes)
            add(so, one, rows.size(), clip);
        so.row.numbers = {numberText(so.weighted, 1)};
        rows.push_back(std::move(so));
    }
    std::ranges::stable_sort(rows, {}, &ClassRow::weighted);
    for (ClassRow& so : rows)
        chart.rows.push_back(std::move(so.row));
    return withSharedNote(std::move(chart));
}

} // namespace app
