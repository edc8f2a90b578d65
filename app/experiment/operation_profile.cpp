// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/operation_profile.h"

#include "app/base/progress.h"
#include "app/base/text.h"

#include <algorithm>
#include <numeric>

namespace app {
namespace {

using clipping::OperationCounts;

constexpr std::uint64_t profileBlockSize = 100'000;

OperationCounts sum(const OperationCounts& a, const OperationCounts& b)
{
    return {a.additions + b.additions, a.multiplications + b.multiplications,
            a.divisions + b.divisions, a.comparisons + b.comparisons, a.negations + b.negations};
}

using LinesByClass = std::array<std::vector<clipping::Segment>, lineClasses.size()>;

LinesByClass divided(std::span<const clipping::Segment> lines, const clipping::Window& window)
{
    LinesByClass classes;
    for (const clipping::Segment& line : lines)
        classes[std::size_t(lineClassOf(line, window))].push_back(line);
    return classes;
}

void count(OperationProfile& profile, const LinesByClass& classes, const TurnProgress& turns)
{
    for (std::size_t c = 0; c < classes.size(); ++c) {
        profile.mix[c] += classes[c].size();
        for (auto& [variant, byClass] : profile.rows) {
            if (turns.stopped())
                return;
            const auto& uses = *clipping::functionsOf(*variant.algorithm, variant.form);
            byClass[c] = sum(byClass[c], uses.count(classes[c], profile.options.field.window));
        }
    }
}

QStringList operationRow(const Variant& variant, const QString& lineClass, std::uint64_t lines,
                         const OperationCounts& counts)
{
    const auto perLine = [&](std::uint64_t count) {
        return QString::number(double(count) / double(lines), 'f', 2);
    };
    return {QString::fromUtf8(variant.algorithm->key),
            wordOf(variant.form),
            lineClass,
            QString::number(lines),
            perLine(counts.comparisons),
            perLine(counts.additions),
            perLine(counts.multiplications),
            perLine(counts.divisions),
            perLine(promisedOf(counts))};
}

} // namespace

OperationCounts VariantOperations::scene() const
{
    return std::accumulate(byClass.begin(), byClass.end(), OperationCounts{}, sum);
}

std::optional<OperationProfile> operationProfile(const ExperimentOptions& options,
                                                 std::span<const Variant> variants,
                                                 const Follower& follower)
{
    OperationProfile profile{.options = options, .rows = {}};
    for (const Variant& variant : variants)
        profile.rows.push_back({variant, {}});
    const LineSource source = options.scene.begin(options.field, options.seed);
    const std::uint64_t blocks = (options.lines + profileBlockSize - 1) / profileBlockSize;
    TurnProgress turns(follower, double(blocks));
    std::vector<clipping::Segment> lines;
    for (std::uint64_t done = 0; done < options.lines; done += lines.size()) {
        if (turns.stopped())
            return std::nullopt;
        lines.resize(std::min(profileBlockSize, options.lines - done));
        source(lines);
        count(profile, divided(lines, options.field.window), turns);
        turns.turnDone();
    }
    if (turns.stopped())
        return std::nullopt;
    return profile;
}

Table operationTable(const OperationProfile& profile)
{
    Table table{
        .names = {"algorithm", "form", "class", "lines_of_class", "comparisons", "additions",
                  "multiplications", "divisions", "all"},
        .title = Text::tr("Operations per line, by class of line"),
        .key = QStringLiteral("operations"),
        .facts = factsOf(profile.options),
        .notes = {Text::tr(
            "Additions include subtractions. Negations and operations on bits are not counted.")}};
    for (const VariantOperations& row : profile.rows) {
        for (std::size_t c = 0; c < profile.mix.size(); ++c)
            if (profile.mix[c] > 0)
                table.rows.push_back(operationRow(row.variant, classText(lineClasses[c]),
                                                  profile.mix[c], row.byClass[c]));
        table.rows.push_back(
            operationRow(row.variant, Text::tr("whole scene"), profile.options.lines, row.scene()));
    }
    return table;
}

} // namespace app
