// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/attempt.h"

#include "app/lessons/families.h"

#include <numeric>

namespace app {

namespace {

std::size_t below(Random& random, std::size_t count)
{
    return std::min(count - 1, std::size_t(random.between(0, double(count))));
}

bool canBeAsked(const LessonPage& page)
{
    const Narration narration = narrationOf(page.tracedLine);
    const auto step = stepFor(page, narration);
    return step && (!page.question || questionOf(page, narration, *step));
}

} // namespace

LessonPage drawnPage(const LessonPage& page, std::uint64_t seed)
{
    constexpr int families = 10, linesOfEach = 400;
    if (seed == 0 || page.families.isEmpty())
        return page;
    Random random(seed);
    LessonPage drawn = page;
    for (int i = 0; i < families; ++i) {
        const auto which = qsizetype(below(random, std::size_t(page.families.size())));
        const LineFamily* family = findLineFamily(page.families[which]);
        for (int k = 0; family && k < linesOfEach; ++k) {
            drawn.tracedLine.line = family->draw(random, page.tracedLine.window);
            if (family->fits(drawn.tracedLine) && canBeAsked(drawn))
                return drawn;
        }
    }
    return page;
}

Question inNewOrder(Question question, std::uint64_t seed)
{
    if (seed == 0)
        return question;
    const auto count = std::size_t(question.choices.size());
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    Random random(mixed(seed)); // other numbers than those of the line
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[below(random, i)]);
    const Question before = question;
    for (std::size_t i = 0; i < count; ++i) {
        question.choices[qsizetype(i)] = before.choices[qsizetype(order[i])];
        if (!before.parts.empty())
            question.parts[i] = before.parts[order[i]];
        if (int(order[i]) == before.right)
            question.right = int(i);
    }
    return question;
}

} // namespace app
