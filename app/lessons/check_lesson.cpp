// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/check_lesson.h"

#include "app/base/text.h"
#include "app/lessons/attempt.h"

#include <algorithm>

namespace app {

namespace {

/// Why a page cannot be taught, at the first line that is wrong; empty: it can.
std::optional<LessonFault> faultOf(const LessonPage& page, const PageLines& lines)
{
    const Narration narration = narrationOf(page.tracedLine);
    if (!narration.refusal.isEmpty())
        return LessonFault{lines.look,
                           Text::tr("The line cannot be shown. %1").arg(narration.refusal)};
    const auto step = stepFor(page, narration);
    if (!step)
        return LessonFault{lines.step > 0 ? lines.step : lines.first,
                           Text::tr("The %L1 steps of this line have no “%2”.")
                               .arg(narration.steps.size())
                               .arg(page.step)};
    if (page.question && !questionOf(page, narration, *step))
        return LessonFault{
            lines.ask,
            Text::tr("“:: ask %1” needs %2.").arg(page.question->kind, needOf(*page.question))};
    return std::nullopt;
}

/// Whether the families of a page draw a line for it.
bool drawsLines(const LessonPage& page)
{
    const std::uint64_t seed = 1;
    return page.families.isEmpty() || drawnPage(page, seed).tracedLine != page.tracedLine
           || drawnPage(page, seed + 1).tracedLine != page.tracedLine;
}

} // namespace

std::vector<LessonFault> faultsOf(const ParsedLesson& parsed)
{
    std::vector<LessonFault> faults;
    const auto& pages = parsed.lesson.pages;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const PageLines& lines = parsed.lines[i];
        if (auto fault = faultOf(pages[i], lines))
            faults.push_back(*std::move(fault));
        else if (!drawsLines(pages[i]))
            faults.push_back(
                {lines.draw, Text::tr("“:: draw %1” finds no line at this window for the page's "
                                      "step and question; each attempt would have the same line.")
                                 .arg(pages[i].families.join(u' '))});
    }
    return faults;
}

} // namespace app
