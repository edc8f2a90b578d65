// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/case_use.h"

#include "app/base/text.h"
#include "app/document/document_builder.h"
#include "app/hard_cases/case_answer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

// The extents of drawings that a canvas can show and zoom to, in user units.
constexpr double leastExtent = 1e-6, mostExtent = 1e12;

} // namespace

TracedLine tracedLineOf(const HardCase& hard, const Variant& variant)
{
    return {.variant = variant,
            .line = hard.line,
            .window = hard.window,
            .y = YAxis::Up,
            .origin = hard.title};
}

Result<Document> documentOf(const HardCase& hard)
{
    using R = Result<Document>;
    const auto& [min, max] = hard.window;
    const auto& [a, b] = hard.line;
    for (const double number : {a.x, a.y, b.x, b.y, min.x, min.y, max.x, max.y})
        if (!std::isfinite(number))
            return R::failure(Text::tr("A drawing cannot hold infinities or NaNs."));
    if (!(min.x <= max.x && min.y <= max.y))
        return R::failure(Text::tr("A drawing cannot hold an inverted window."));
    const Point low = glm::min(glm::min(a, b), min), high = glm::max(glm::max(a, b), max);
    const double extent = std::max(high.x - low.x, high.y - low.y);
    if (extent > mostExtent)
        return R::failure(Text::tr("These numbers are too large for a drawing."));
    if (extent > 0 && extent < leastExtent)
        return R::failure(Text::tr("These numbers are too small for a drawing."));
    const double around = extent > 0 ? extent * 0.1 : 1;
    Page page{.min = low - around, .size = high - low + 2 * around};
    const Point millimetres = page.size * (200 / (extent + 2 * around));
    page.width = {millimetres.x, Unit::Mm};
    page.height = {millimetres.y, Unit::Mm};
    DocumentBuilder builder;
    builder.open({.name = QStringLiteral("Drawing")});
    builder.addLine(hard.line,
                    builder.style({.stroke = Colour{}, .width = (extent + 2 * around) / 400}));
    builder.close();
    return R::of(builder.take(page, {}, {{{.shape = RectangleShape{hard.window}}}}));
}

Variant firstToLookAt(const HardCase& hard)
{
    const std::vector<CaseAnswer> answers = answersTo(hard);
    const auto interest = [](const CaseAnswer& answer) {
        if (answer.good())
            return -1.0;
        if (answer.variant.misprint)
            return -0.5;
        return answer.ruling == Ruling::DidNotEnd
                   ? mostExtent
                   : std::floor(std::min(answer.beyond, mostExtent / 2));
    };
    return std::ranges::max_element(answers, {}, interest)->variant;
}

} // namespace app
