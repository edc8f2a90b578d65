// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/difference.h"

#include <QStringList>

namespace app {

using clipping::Clipped;
using clipping::Window;

namespace {

void add(Disagreement& to, std::span<const Difference> fromExact, std::size_t firstLine)
{
    const DifferenceCounts counts = counted(fromExact);
    to.lost += counts.onlyB;
    to.shown += counts.onlyA;
    to.moved += counts.endsApart;
    for (const Difference& difference : fromExact)
        to.segments.push_back(std::uint32_t(firstLine) + difference.source);
}

/// The variants that are judged by `exact`: the published form first.
std::vector<Disagreement> allToJudge(const Variant& chosen)
{
    std::vector<Disagreement> all;
    if (chosen.form == clipping::Form::Published)
        all.push_back({.variant = chosen});
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        if (&algorithm != &clipping::exactAlgorithm())
            all.push_back({.variant = {&algorithm}});
    return all;
}

/// Adds the differences in the lines of one run.
void judge(std::vector<Disagreement>& all, const SceneLines::Run& run, const Window& window)
{
    const Variant exact{&clipping::exactAlgorithm()};
    const std::vector<Clipped> truth = clipped(exact, run.segments, window);
    for (Disagreement& one : all)
        add(one,
            differences(run.segments, window, clipped(one.variant, run.segments, window), truth,
                        {contractUlps(one.variant, exact), endsOf(one.variant, exact)}),
            run.firstLine);
}

QString counted(const char* one, const char* many, std::size_t count)
{
    return count == 1 ? Text::tr(one) : Text::tr(many).arg(countText(count));
}

QString sentence(const Disagreement& disagreement)
{
    QStringList faults;
    if (disagreement.lost)
        faults << counted(QT_TRANSLATE_NOOP("Text", "loses 1 line that is visible"),
                          QT_TRANSLATE_NOOP("Text", "loses %1 lines that are visible"),
                          disagreement.lost);
    if (disagreement.shown)
        faults << counted(QT_TRANSLATE_NOOP("Text", "keeps 1 line that is not visible"),
                          QT_TRANSLATE_NOOP("Text", "keeps %1 lines that are not visible"),
                          disagreement.shown);
    if (disagreement.moved)
        faults << counted(QT_TRANSLATE_NOOP("Text", "misplaces the ends of 1 line"),
                          QT_TRANSLATE_NOOP("Text", "misplaces the ends of %1 lines"),
                          disagreement.moved);
    return nameOf(disagreement.variant) + u' ' + faults.join(Text::tr(", "));
}

} // namespace

std::vector<Disagreement> disagreements(const SceneLines& lines, const Window& window,
                                        const Variant& chosen, const std::stop_token& stop)
{
    std::vector<Disagreement> found = allToJudge(chosen);
    for (const SceneLines::Run& run : lines.runs())
        if (!stop.stop_requested())
            judge(found, run, window);
    std::erase_if(found, [](const Disagreement& one) { return one.none(); });
    return found;
}

QString sentence(std::span<const Disagreement> disagreements)
{
    if (disagreements.empty())
        return Text::tr("All corrected algorithms agree here");
    QStringList sentences;
    for (const Disagreement& disagreement : disagreements)
        sentences << sentence(disagreement);
    return sentences.join(QStringLiteral("; "));
}

} // namespace app
