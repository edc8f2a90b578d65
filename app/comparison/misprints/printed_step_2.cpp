// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 2 of Matthes and Drakopoulos as their text prints it. The pseudo-code is correct, but the
// formulas of the text have two errors: the two that cut at ymin and ymax multiply by (ymin - x1)
// and (ymax - x1), where y1 is meant; and they assign to x1 and y1, which later formulas still need
// as the line's first end. Steps 1 and 3 are those of the pseudo-code.

#include "app/base/text.h"
#include "app/comparison/misprints/misprint.h"

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

/// Prevents line breaks at the signs of formulas.
QString unbroken(QString text)
{
    for (const QChar sign : {u'−', u'+', u'·', u'='})
        text.replace(u' ' + QString(sign) + u' ', u'\u00a0' + QString(sign) + u'\u00a0');
    return text;
}

/// Whether the formulas read the original line, or ends that they have already moved.
enum class Reading : std::uint8_t { Beside, InPlace };

/// Moves end p as printed. `s` is the line in the formulas; with InPlace, p is an end of it.
void push(glm::dvec2& p, const Segment& s, const Window& w)
{
    const glm::dvec2 &a = s.a, &b = s.b;
    const auto toX = [&](double x) {
        p.x = x;
        p.y = a.y + (b.y - a.y) / (b.x - a.x) * (x - a.x);
    };
    const auto toY = [&](double y) {
        p.y = y;
        p.x = a.x + (b.x - a.x) / (b.y - a.y) * (y - a.x); // should be y - a.y
    };
    if (p.x < w.min.x)
        toX(w.min.x);
    else if (p.x > w.max.x)
        toX(w.max.x);
    if (p.y < w.min.y)
        toY(w.min.y);
    else if (p.y > w.max.y)
        toY(w.max.y);
}

bool beyond(double a, double b, double low, double high)
{
    return (a < low && b < low) || (a > high && b > high);
}

template <Reading reading>
bool isVisible(Segment& visible, const Window& w)
{
    const Segment given = visible;
    if (beyond(given.a.x, given.b.x, w.min.x, w.max.x)
        || beyond(given.a.y, given.b.y, w.min.y, w.max.y))
        return false;
    const Segment& line = reading == Reading::InPlace ? visible : given;
    push(visible.a, line, w);
    push(visible.b, line, w);
    return !beyond(visible.a.x, visible.b.x, w.min.x, w.max.x);
}

template <Reading reading>
std::size_t clipAll(std::span<const Segment> in, const Window& window, std::span<Clipped> out)
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < in.size(); ++i) {
        Segment visible = in[i];
        if (isVisible<reading>(visible, window))
            out[count++] = {visible, i, 0};
    }
    return count;
}

} // namespace

Misprint printedStep2()
{
    return {
        QStringLiteral("md-step-2"), Text::tr("MD with Step 2 as printed"),
        unbroken(Text::tr(
            "The text of the paper cuts at the window's edges ymin and ymax with (ymin − x1) and "
            "(ymax − x1). It should read (ymin − y1) and (ymax − y1), as in the pseudo-code: x = "
            "x1 + (x2 − x1)/(y2 − y1) · (ymin − y1). A line that crosses one of these edges is cut "
            "at the wrong place, or kept although it misses the window.")),
        clipping::findAlgorithm("matthes-drakopoulos"), clipAll<Reading::Beside>};
}

Misprint printedStep2InPlace()
{
    return {
        QStringLiteral("md-step-2-in-place"), Text::tr("MD with Step 2 as printed, read literally"),
        unbroken(Text::tr(
            "Read literally, Step 2 also assigns new values to x1 and y1 before it computes with "
            "them. After x1 = xmin, the difference xmin − x1 is zero: y1 does not change, and a "
            "later formula may divide 0 by 0. The pseudo-code keeps the cut ends in separate "
            "variables, x[i] and y[i]. It has (ymin − y1) where the text has (ymin − x1).")),
        clipping::findAlgorithm("matthes-drakopoulos"), clipAll<Reading::InPlace>};
}

} // namespace app
