// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_text.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/line_text.h"

namespace app {

QString figureText(const TracedLine& tracedLine, const Narration& narration, std::size_t step)
{
    const auto point = [](double x, double y) { return pairText(shortText(x), shortText(y)); };
    const auto& line = tracedLine.line;
    const auto& window = tracedLine.window;
    QStringList sentences{
        tracedLine.corners.empty()
            ? Text::tr("The clip window is a rectangle from %1 to %2.")
                  .arg(point(window.min.x, window.min.y), point(window.max.x, window.max.y))
            : Text::tr("The clip window is a polygon with %1 corners.")
                  .arg(tracedLine.corners.size()),
        Text::tr("The line runs from End 1 at %1 to End 2 at %2.")
            .arg(point(line.a.x, line.a.y), point(line.b.x, line.b.y))};
    if (step < narration.steps.size())
        sentences << narration.steps[step].sentence;
    return sentences.join(u' ');
}

} // namespace app
