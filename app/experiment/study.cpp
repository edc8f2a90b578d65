// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/study.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/experiment/class_lines.h"
#include "app/experiment/one_by_one.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

/// Operations per line of all variants together, estimated on some lines of the scene: some
/// algorithms need a hundred times as many as others.
double operationsOf(const PlannedTrial& trial)
{
    std::vector<clipping::Segment> some(std::min<std::uint64_t>(trial.options.lines, 200));
    trial.options.scene.begin(trial.options.field, trial.options.seed)(some);
    std::uint64_t all = 0;
    for (const Variant& one : trial.variants) {
        all += promisedOf(clipping::functionsOf(*one.algorithm, one.form)
                              ->count(some, trial.options.field.window));
    }
    return double(all) / double(some.size());
}

/// The mean number of visible pixels per line of the scene.
double pixelsOf(const PlannedTrial& trial)
{
    const Field& field = trial.options.field;
    std::vector<clipping::Segment> some(std::min<std::uint64_t>(trial.options.lines, 2000));
    trial.options.scene.begin(field, trial.options.seed)(some);
    std::vector<clipping::Clipped> visible(some.size());
    visible.resize(clipping::functionsOf(clipping::exactAlgorithm(), clipping::Form::Corrected)
                       ->clipAll(some, field.window, visible));
    double length = 0;
    for (const clipping::Clipped& line : visible) {
        const auto way = line.segment.b - line.segment.a;
        length += 1 + std::max(std::abs(way.x), std::abs(way.y)) * fitOf(field).scale;
    }
    return length / double(some.size());
}

/// A rough duration in nanoseconds, to share progress fairly.
double weightOf(const PlannedTrial& trial)
{
    const double each = double(trial.variants.size());
    const double make = 40, find = 20, draw = trial.options.target ? 20 + 50 * pixelsOf(trial) : 0;
    const auto& [runs, warmUps] = std::pair(trial.options.runs, trial.options.warmUps);
    const std::size_t rounds = trial.options.inProcesses ? runs * (1 + warmUps) : runs + warmUps;
    return double(trial.options.lines) * double(rounds)
           * (make + operationsOf(trial) + each * (find + draw));
}

struct ExplanationWeights {
    double classes, operations, accuracies;
};

ExplanationWeights explanationWeights(const PlannedTrial& trial)
{
    const double each = double(trial.variants.size()), lines = double(trial.options.lines);
    const double operations = operationsOf(trial), look = 100;
    const std::size_t ofAClass = mostOfAClass(trial.options);
    return {look * double(linesLookedThrough(ofAClass))
                + double(lineClasses.size() * ofAClass) * operations
                      * double(trial.options.runs + trial.options.warmUps),
            lines * (10 * each + 8 * operations), lines * (30 * each + operations)};
}

std::vector<double> weightsOf(const Plan& plan)
{
    std::vector<double> weights;
    for (const PlannedTrial& trial : plan.trials)
        weights.push_back(weightOf(trial));
    if (plan.explained) {
        const auto [classes, operations, accuracies] = explanationWeights(*plan.explained);
        weights.insert(weights.end(), {classes, operations, accuracies});
    }
    return weights;
}

std::optional<Explanation> explanationOf(const PlannedTrial& trial, PhasedProgress& phases)
{
    auto classes = classProfile(trial.options, trial.variants, phases.next());
    if (!classes)
        return std::nullopt;
    const auto once = withoutOneByOne(trial.variants);
    auto operations = operationProfile(trial.options, once, phases.next());
    if (!operations)
        return std::nullopt;
    auto right = accuracies(trial.options, once, phases.next());
    if (!right)
        return std::nullopt;
    return Explanation{std::move(*classes), std::move(*operations), std::move(*right)};
}

bool drewNothing(const Study& study)
{
    return std::ranges::all_of(study.trials, [](const Trial& trial) {
        return std::ranges::all_of(trial.record.timings,
                                   [](const Timing& timing) { return timing.found.visible == 0; });
    });
}

bool tellsOfDrawingAlone(const Measure& measure)
{
    const Timing undrawn{.variant = {}, .generate = {1}, .clip = {1}, .draw = {0}};
    return measure.times(undrawn).front() == 0;
}

using Facts = std::vector<std::pair<QString, QString>>;

/// The facts that both have in common.
Facts shared(const Facts& facts, const Facts& others)
{
    Facts both;
    std::ranges::copy_if(facts, std::back_inserter(both), [&](const auto& fact) {
        return std::ranges::find(others, fact) != others.end();
    });
    return both;
}

} // namespace

std::vector<PlannedTrial> paperTrials(std::span<const PaperTable> papers,
                                      std::span<const clipping::Form> forms,
                                      const ExperimentOptions& options,
                                      std::optional<std::uint64_t> lines)
{
    std::vector<PlannedTrial> trials;
    for (const PaperTable& paper : papers)
        for (const clipping::Form form : forms) {
            trials.push_back({paper, options, variantsOf(paper, form)});
            trials.back().options.lines = lines.value_or(paper.lines);
        }
    return trials;
}

void takeUsualRuns(Plan& plan)
{
    const auto take = [](PlannedTrial& trial) {
        trial.options.runs = usualRounds(trial.variants.size());
    };
    std::ranges::for_each(plan.trials, take);
    if (plan.explained)
        take(*plan.explained);
}

double roughSeconds(const Plan& plan)
{
    const auto weights = weightsOf(plan);
    return 1e-9 * std::accumulate(weights.begin(), weights.end(), 0.0);
}

namespace {

/// Adds the explanation to a study with all its trials.
std::optional<Study> finished(Study study, const Plan& plan, PhasedProgress& phases)
{
    if (drewNothing(study) && study.measures.size() > 1)
        std::erase_if(study.measures, tellsOfDrawingAlone);
    if (plan.explained) {
        study.explanation = explanationOf(*plan.explained, phases);
        if (!study.explanation)
            return std::nullopt;
    }
    return study;
}

} // namespace

std::optional<Study> study(const Plan& plan, std::vector<Record> records, const Follower& follower)
{
    PhasedProgress phases(follower, weightsOf({{}, plan.measures, plan.explained}));
    Study study{.measures = plan.measures, .trials = {}};
    for (std::size_t i = 0; i < records.size(); ++i)
        study.trials.push_back({plan.trials[i].paper, std::move(records[i])});
    return finished(std::move(study), plan, phases);
}

std::optional<Study> study(const Plan& plan, const Follower& follower)
{
    PhasedProgress phases(follower, weightsOf(plan));
    Study study{.measures = plan.measures, .trials = {}};
    for (const PlannedTrial& trial : plan.trials) {
        auto record = recorded(trial.options, trial.variants, phases.next());
        if (!record)
            return std::nullopt;
        study.trials.push_back({trial.paper, std::move(*record)});
    }
    return finished(std::move(study), plan, phases);
}

QString nameOf(const Trial& trial)
{
    if (!trial.paper)
        return trial.record.options.scene.name;
    const bool published = trial.record.timings.front().variant.form == clipping::Form::Published;
    const QString name = published ? Text::tr("%1, as published").arg(numberOf(*trial.paper))
                                   : Text::tr("%1, corrected").arg(numberOf(*trial.paper)),
                  lines = otherLinesText(trial.record.options);
    return lines.isEmpty() ? name : Text::tr("%1, with %2").arg(name, lines);
}

std::vector<Table> tablesOf(const Trial& trial, const Measure& measure, Against against)
{
    if (!trial.paper)
        return {timesTable(trial.record, measure)};
    std::vector<Table> tables{paperLayout(*trial.paper, trial.record, measure)};
    if (against == Against::Paper)
        tables.push_back(againstPaper(*trial.paper, trial.record, measure));
    return tables;
}

std::vector<Table> tablesOf(const Explanation& explanation)
{
    return {classTable(explanation.classes), operationTable(explanation.operations),
            accuracyTable(explanation.accuracies, explanation.operations.options)};
}

/// The times of a trial with its name, for a study with several trials.
Table namedTimesTable(const Trial& trial, const Measure& measure)
{
    Table table = timesTable(trial.record, measure);
    table.key = trial.paper->key + u'-' + table.key + QStringLiteral("-times-")
                + wordOf(trial.record.timings.front().variant.form);
    table.title.prepend(nameOf(trial) + QStringLiteral(": "));
    return table;
}

std::vector<Table> tablesOf(const Study& study)
{
    std::vector<Table> tables;
    const PaperTable* last = nullptr;
    for (const Trial& trial : study.trials) {
        if (trial.paper && !(last && last->key == trial.paper->key))
            tables.push_back(paperLayout(*trial.paper));
        last = trial.paper ? &*trial.paper : nullptr;
        for (const Measure& measure : study.measures) {
            std::ranges::move(tablesOf(trial, measure, Against::Paper), std::back_inserter(tables));
            if (trial.paper)
                tables.push_back(namedTimesTable(trial, measure));
        }
    }
    if (study.explanation)
        std::ranges::move(tablesOf(*study.explanation), std::back_inserter(tables));
    return tables;
}

Table circumstancesTable(const Study& study)
{
    Table table{.names = {"what", "value"},
                .title = Text::tr("Circumstances"),
                .key = QStringLiteral("circumstances")};
    Facts facts;
    for (const Trial& trial : study.trials)
        facts = &trial == &study.trials.front() ? factsOf(trial.record)
                                                : shared(facts, factsOf(trial.record));
    for (const auto& [name, value] : facts)
        table.rows.push_back({name, value});
    return table;
}

} // namespace app
