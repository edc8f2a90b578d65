// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/question.h"

#include <glm/geometric.hpp>

#include <array>

namespace app {

namespace {

/// How far a point is left of the line, seen from End 1 to End 2.
double leftOf(const clipping::Segment& line, const Point& p, YAxis y)
{
    const Point along = line.b - line.a, to = p - line.a;
    const double up = along.x * to.y - along.y * to.x;
    return (y == YAxis::Up ? up : -up) / glm::length(along);
}

/// "ask corners": how many corners of the window are left of the line. Not of a line that passes
/// one so near that the eye cannot tell.
std::optional<Question> askCorners(const TracedLine& tracedLine, const Narration&, std::size_t,
                                   const QStringList&)
{
    const auto& [min, max] = tracedLine.window;
    const double clear = 0.04 * std::min(max.x - min.x, max.y - min.y);
    int left = 0;
    for (const Point& corner : {min, Point(max.x, min.y), max, Point(min.x, max.y)}) {
        const double distance = leftOf(tracedLine.line, corner, tracedLine.y);
        if (!(std::abs(distance) > clear))
            return std::nullopt;
        left += distance > 0;
    }
    QStringList choices;
    for (const char* words : {QT_TRANSLATE_NOOP("Text", "None"), QT_TRANSLATE_NOOP("Text", "One"),
                              QT_TRANSLATE_NOOP("Text", "Two"), QT_TRANSLATE_NOOP("Text", "Three"),
                              QT_TRANSLATE_NOOP("Text", "All four")})
        choices << Text::tr(words);
    return Question{Text::tr("How many corners are to your left, from End 1 to End 2?"), choices,
                    left,
                    Text::tr("Corners to the left: %1, to the right: %2.").arg(left).arg(4 - left),
                    Text::tr("Extend the line beyond its ends. Stand at End 1 and look at End 2: "
                             "which corners are on your left hand's side?")};
}

} // namespace

extern const QuestionKind cornersQuestion;
const QuestionKind cornersQuestion{
    "corners", askCorners, Covered::AllSteps, 5,
    QT_TRANSLATE_NOOP("Text", "a line that passes no corner of the window closely")};

} // namespace app
