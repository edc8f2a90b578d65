// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 2 of Matthes and Drakopoulos as their text prints it. The pseudo-code is correct, but the
// formulas of the text have two errors: the two that cut at ymin and ymax multiply by (ymin - x1)
// and (ymax - x1), where y1 is meant; and they assign to x1 and y1, which later formulas still need
// as the line's first end. Steps 1 and 3 are those of the pseudo-code.

#include "app/base/text.h"
#include "app/comparison/misprints/misprint.h"
#include "app/comparison/misprints/uses.h"

namespace app {
namespace {

using clipping::BasicSegment;
using clipping::BasicWindow;
using clipping::Edge;

/// Prevents line breaks at the signs of formulas.
QString unbroken(QString text)
{
    for (const QChar sign : {u'−', u'+', u'·', u'='})
        text.replace(u' ' + QString(sign) + u' ', u'\u00a0' + QString(sign) + u'\u00a0');
    return text;
}

/// The formulas read the line that was given.
struct Beside {
    static constexpr bool movesFirst = false; ///< an end before the formula is computed
    /// The line that the formulas read, while the ends `now` are moved.
    template <class S>
    static constexpr const S& line(const S& given, const S&)
    {
        return given;
    }
};

/// The formulas read ends that they have already moved.
struct InPlace {
    static constexpr bool movesFirst = true;
    template <class S>
    static constexpr const S& line(const S&, const S& now)
    {
        return now;
    }
};

/// The pseudo-code of the algorithm meant, with the formulas of the text.
std::string codeBeside(std::string_view meant)
{
    std::string code(meant);
    for (const auto& [right, printed] :
         {std::pair{"(ymin-y1)", "(ymin-x1)"}, std::pair{"(ymax-y1)", "(ymax-x1)"}})
        if (const auto at = code.find(right); at != code.npos)
            code.replace(at, std::string_view(right).size(), printed);
    return code;
}

constexpr std::string_view codeInPlace =
    R"(if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
for i = 1, 2
  if x[i] < xmin  #left
    x[i] = xmin  #atLeft
    rise = (y[2]-y[1])/(x[2]-x[1]) * (xmin-x[1])  #riseToLeft
    y[i] = rise + y[1]  #toLeft
  else if x[i] > xmax  #right
    x[i] = xmax  #atRight
    rise = (y[2]-y[1])/(x[2]-x[1]) * (xmax-x[1])  #riseToRight
    y[i] = rise + y[1]  #toRight
  if y[i] < ymin  #bottom
    y[i] = ymin  #atBottom
    run = (x[2]-x[1])/(y[2]-y[1]) * (ymin-x[1])  #runToBottom
    x[i] = run + x[1]  #toBottom
  else if y[i] > ymax  #top
    y[i] = ymax  #atTop
    run = (x[2]-x[1])/(y[2]-y[1]) * (ymax-x[1])  #runToTop
    x[i] = run + x[1]  #toTop
if (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)  #missed
  reject  #reject
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";

/// Whether an axis alone rules the line out.
template <class T>
constexpr bool beyond(T a, T b, T low, T high)
{
    return (a < low && b < low) || (a > high && b > high);
}

/// The labels of a move to an edge.
struct MoveLabels {
    std::string_view first, formula, end;
};

template <class Reading>
struct PrintedStep2 {
    /// Moves end i of `now` to an edge.
    template <class T, class Step>
    static constexpr void move(Step& step, const MoveLabels& labels, int i, T level, Edge edge,
                               const BasicSegment<T>& given, BasicSegment<T>& now)
    {
        const glm::length_t along = clipping::axisOf(edge), across = 1 - along;
        auto& end = i == 0 ? now.a : now.b;
        end[along] = level;
        if (Reading::movesFirst)
            step.cut(labels.first, i, end.x, end.y, edge);
        const auto& [a, b] = Reading::line(given, now);
        const T way = // should be level - a[along]
            step.let(labels.formula, along == 0 ? "rise" : "run",
                     (b[across] - a[across]) / (b[along] - a[along]) * (level - a.x), edge);
        end[across] = way + a[across];
        step.cut(labels.end, i, end.x, end.y, edge);
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        if (step.test("besideX", beyond(s.a.x, s.b.x, w.min.x, w.max.x), Edge::Left, Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", beyond(s.a.y, s.b.y, w.min.y, w.max.y), Edge::Bottom, Edge::Top))
            return step.reject("rejectY");
        BasicSegment<T> now = s;
        for (int i = 0; i < 2; ++i) {
            const auto& end = i == 0 ? now.a : now.b;
            step.set("i", i + 1);
            if (step.test("left", end.x < w.min.x, Edge::Left))
                move(step, {"atLeft", "riseToLeft", "toLeft"}, i, w.min.x, Edge::Left, s, now);
            else if (step.test("right", end.x > w.max.x, Edge::Right))
                move(step, {"atRight", "riseToRight", "toRight"}, i, w.max.x, Edge::Right, s, now);
            if (step.test("bottom", end.y < w.min.y, Edge::Bottom))
                move(step, {"atBottom", "runToBottom", "toBottom"}, i, w.min.y, Edge::Bottom, s,
                     now);
            else if (step.test("top", end.y > w.max.y, Edge::Top))
                move(step, {"atTop", "runToTop", "toTop"}, i, w.max.y, Edge::Top, s, now);
        }
        if (step.test("missed", beyond(now.a.x, now.b.x, w.min.x, w.max.x), Edge::Left,
                      Edge::Right))
            return step.reject("reject");
        return step.accept("accept", now);
    }
};

const clipping::Algorithm& meant() { return *clipping::findAlgorithm("matthes-drakopoulos"); }

template <class Reading>
Misprint printed(const QString& key, const QString& name, const QString& whatIsWrong,
                 std::string_view code)
{
    Misprint misprint{key, name, unbroken(whatIsWrong), &meant(), meant()};
    misprint.row.published = &MisprintUses<PrintedStep2<Reading>>::all;
    misprint.row.publishedCode = code;
    return misprint;
}

} // namespace

Misprint printedStep2()
{
    static const std::string code = codeBeside(meant().publishedCode);
    return printed<Beside>(
        QStringLiteral("md-step-2"), Text::tr("MD with Step 2 as printed"),
        Text::tr(
            "The text of the paper cuts at the window's edges ymin and ymax with (ymin − x1) and "
            "(ymax − x1). It should read (ymin − y1) and (ymax − y1), as in the pseudo-code: x = "
            "x1 + (x2 − x1)/(y2 − y1) · (ymin − y1). A line that crosses one of these edges is cut "
            "at the wrong place, or kept although it misses the window."),
        code);
}

Misprint printedStep2InPlace()
{
    return printed<InPlace>(
        QStringLiteral("md-step-2-in-place"), Text::tr("MD with Step 2 as printed, read literally"),
        Text::tr(
            "Read literally, Step 2 also assigns new values to x1 and y1 before it computes with "
            "them. After x1 = xmin, the difference xmin − x1 is zero: y1 does not change, and a "
            "later formula may divide 0 by 0. The pseudo-code keeps the cut ends in separate "
            "variables, x[i] and y[i]. It has (ymin − y1) where the text has (ymin − x1)."),
        codeInPlace);
}

} // namespace app
