// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/choice.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/experiment/one_by_one.h"
#include "app/scene/compared_window.h"
#include "app/scene/window_needs.h"

#include <algorithm>

namespace app {
namespace {

/// More lines than this do not change operation counts and accuracy noticeably.
constexpr std::uint64_t mostExplained = 1'000'000;

ExperimentOptions optionsOf(const Choice& choice)
{
    ExperimentOptions options = choice.subject.options;
    options.lines = choice.lines.value_or(options.lines);
    options.runs = choice.runs.value_or(options.runs);
    options.seed = choice.seed;
    options.order = choice.order;
    options.target = choice.target;
    options.inProcesses = choice.inProcesses;
    return options;
}

std::vector<Variant> chosenVariants(const Choice& choice)
{
    std::vector<Variant> all;
    for (const clipping::Form form : choice.forms)
        for (const Variant& one : choice.subject.papers.empty()
                                      ? variantsOf(choice.algorithms, form)
                                      : variantsOf(choice.subject.papers.front(), form))
            all.push_back(one);
    all = withOneByOne(all); // no table of the paper has `exact`
    const auto& shape = choice.subject.options.field.shape;
    return shape ? withoutUnable(*shape, std::move(all)) : all;
}

std::vector<PlannedTrial> trialsOf(const Choice& choice)
{
    const ExperimentOptions options = optionsOf(choice);
    if (choice.subject.papers.empty())
        return {{std::nullopt, options, chosenVariants(choice)}};
    return paperTrials(choice.subject.papers, choice.forms, options, choice.lines);
}

std::vector<Measure> measuresOf(const Choice& choice)
{
    std::vector<Measure> all = measures();
    if (!choice.target)
        std::erase_if(all, [](const Measure& measure) { return measure.draws; });
    return all;
}

std::optional<QString> missing(const Choice& choice)
{
    if (choice.subject.papers.empty() && choice.algorithms.empty())
        return Text::tr("Choose at least one algorithm.");
    if (choice.forms.empty() || chosenVariants(choice).empty())
        return choice.subject.options.field.shape
                   ? Text::tr("None of these algorithms clips at this window in this form. "
                              "Choose “Corrected” or other algorithms.")
                   : Text::tr("None of these algorithms has a published form. Choose "
                              "“Corrected” or other algorithms.");
    if (choice.subject.options.field.shape && choice.order == Order::ByClass)
        return Text::tr("Lines are sorted by class at rectangles only. Choose another "
                        "order.");
    const std::uint64_t runs = choice.runs.value_or(1), lines = choice.lines.value_or(1);
    if (runs < 1 || runs > mostRuns || lines < 1 || lines > mostLines)
        return Text::tr("Choose 1 to %1 lines and 1 to %2 runs.")
            .arg(countText(mostLines), countText(mostRuns));
    return std::nullopt;
}

} // namespace

std::vector<Subject> subjects()
{
    const auto papers = paperTables();
    std::vector<Subject> all{
        {"all", Text::tr("Tables 1 and 2 of the paper"),
         Text::tr("The paper's seven algorithms clip one million, then ten million random lines. "
                  "Both ends lie anywhere in an area of 1,920 × 1,440 units."),
         papers}};
    for (const PaperTable& paper : papers)
        all.push_back({paper.key,
                       Text::tr("%1 of the paper").arg(numberOf(paper)),
                       Text::tr("The paper's seven algorithms clip %1 random lines with "
                                "both ends anywhere in an area of 1,920 × 1,440 units.")
                           .arg(countText(paper.lines)),
                       {paper}});
    for (const TestScene& scene : testScenes())
        all.push_back({scene.key,
                       Text::tr("Lines: %1").arg(scene.name.toLower()),
                       scene.meaning,
                       {},
                       {.scene = scene}});
    return all;
}

namespace {

/// The first clip window with an effect that is a rotated rectangle or a convex polygon.
std::shared_ptr<const ShapedWindow> firstShape(const Document& document)
{
    const ClipWindows counting = inEffect(document.windows());
    for (const ClipWindow& window : counting.list)
        if (auto shape = shapedWindow({.shape = window.shape}, document.page());
            shape && refusalOf(*shape).isEmpty())
            return shape;
    return nullptr;
}

QString whereText(const Field& field, bool atPage)
{
    if (field.shape)
        return Text::tr("Its lines: %1. They are clipped at its window: %2. For a larger "
                        "number of lines they are repeated.")
            .arg(QStringLiteral("%1"), shapeText(field.shape->step()));
    return atPage ? Text::tr("Its lines: %1. They are clipped at its page, because it has "
                             "no clip window that is a rectangle or convex. For a larger "
                             "number of lines they are repeated.")
                  : Text::tr("Its lines: %1. They are clipped at its window. For a larger "
                             "number of lines they are repeated.");
}

} // namespace

std::optional<Subject> drawingSubject(const QString& name, const SceneLines& lines,
                                      const Document& document)
{
    if (lines.size() == 0)
        return std::nullopt;
    const Page& page = document.page();
    const ComparedWindow at = comparedWindow(document.windows(), page);
    Field field{page.rectangle(), at.window};
    if (at.isPage)
        field.shape = firstShape(document);
    if (field.shape)
        field.window = field.shape->step().box;
    return Subject{"drawing",
                   Text::tr("Lines of %1").arg(name),
                   whereText(field, at.isPage).arg(countText(lines.size())),
                   {},
                   {.scene = drawingScene(name, lines), .field = field, .lines = lines.size()}};
}

QString leftOutText(const Choice& choice)
{
    QStringList names;
    for (const auto* algorithm : choice.algorithms)
        if (std::ranges::none_of(choice.forms, [&](clipping::Form form) {
                return clipping::functionsOf(*algorithm, form);
            }))
            names << shortNameOf({algorithm, clipping::Form::Corrected});
    if (const auto& shape = choice.subject.options.field.shape) {
        std::vector<Variant> all;
        for (const clipping::Form form : choice.forms)
            std::ranges::copy(variantsOf(choice.algorithms, form), std::back_inserter(all));
        if (const QString unable = unableText(*shape, all); !unable.isEmpty())
            return unable;
    }
    if (!choice.subject.papers.empty() || names.isEmpty())
        return {};
    return Text::tr("Left out, because they have no published form: %1.").arg(briefListText(names));
}

Result<Plan> planOf(const Choice& choice)
{
    if (const auto sentence = missing(choice))
        return Result<Plan>::failure(*sentence);
    Plan plan{trialsOf(choice), measuresOf(choice)};
    // By class, and with exact arithmetic, results are explained at rectangles only.
    if (choice.explained && !choice.subject.options.field.shape) {
        plan.explained = PlannedTrial{std::nullopt, optionsOf(choice), chosenVariants(choice)};
        auto& lines = plan.explained->options.lines;
        lines = std::min(lines, mostExplained);
    }
    if (!choice.runs)
        takeUsualRuns(plan);
    return Result<Plan>::of(std::move(plan));
}

Choice quick(Choice choice)
{
    choice.lines = 30'000;
    choice.runs.reset();
    return choice;
}

QString effortText(const Plan& plan, double durationRatio)
{
    std::uint64_t lines = 0;
    for (const PlannedTrial& trial : plan.trials)
        lines += trial.options.lines * trial.options.runs * trial.variants.size();
    return Text::tr("Run: %1 to clip, about %2.")
        .arg(linesText(lines), durationText(durationRatio * roughSeconds(plan)));
}

QString quickEffortText(const Choice& choice, double durationRatio)
{
    const auto plan = planOf(quick(choice));
    return plan ? Text::tr("Quick run: about %1.")
                      .arg(durationText(durationRatio * roughSeconds(*plan.value)))
                : QString();
}

} // namespace app
