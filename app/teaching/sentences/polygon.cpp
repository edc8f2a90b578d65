// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/polygon.h"

#include "app/base/text.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/sentences/words.h"
#include "clipping/pseudo_code.h"

#include <algorithm>
#include <array>

namespace app {

using clipping::What;

namespace {

/// How a step of the library is told, by its label in the code here: a question or sentence in
/// which %1 is the number of the edge that the variable `edge` names, and %2 the assigned value.
struct PolygonStep {
    std::string_view label;
    const char* text;
    const char* edge = nullptr;
};

struct PolygonTeaching {
    std::string_view key;
    std::string_view code; ///< with labels (clipping/pseudo_code.h)
    std::span<const PolygonStep> steps;
};

constexpr auto bothBeside = QT_TRANSLATE_NOOP(
    "Text", "Are both ends to the left or both to the right of the polygon's bounding box?");
constexpr auto bothBelow =
    QT_TRANSLATE_NOOP("Text", "Are both ends above or both below the polygon's bounding box?");
constexpr auto missed =
    QT_TRANSLATE_NOOP("Text", "Does the infinite line through both ends miss the polygon?");
constexpr auto oneOutside = QT_TRANSLATE_NOOP("Text", "Is End 1 beyond edge %1?");
constexpr auto otherOutside = QT_TRANSLATE_NOOP("Text", "Is End 2 beyond edge %1?");
constexpr auto besideBoth = QT_TRANSLATE_NOOP(
    "Text", "Does the line end before it reaches the polygon, or begin beyond it?");
constexpr auto entersThrough =
    QT_TRANSLATE_NOOP("Text", "The infinite line enters the polygon through edge %1.");
constexpr auto leavesThrough =
    QT_TRANSLATE_NOOP("Text", "The infinite line leaves the polygon through edge %1.");

constexpr std::array cyrusBeck{
    PolygonStep{
        "N",
        QT_TRANSLATE_NOOP(
            "Text", "At edge %1, N = %2 for End 1 (N < 0: it lies beyond the line of this edge)."),
        "edge"},
    PolygonStep{"outside", QT_TRANSLATE_NOOP("Text", "Do both ends lie beyond edge %1?"), "edge"},
    PolygonStep{"t",
                QT_TRANSLATE_NOOP("Text",
                                  "The line crosses the line of edge %1 at t = %2 (0 is End 1, 1 "
                                  "is End 2)."),
                "edge"},
    PolygonStep{"entering", QT_TRANSLATE_NOOP("Text", "Does the line enter at edge %1?"), "edge"},
    PolygonStep{
        "later",
        QT_TRANSLATE_NOOP("Text", "Is the entry at edge %1 after the start of the remaining part?"),
        "edge"},
    PolygonStep{"start",
                QT_TRANSLATE_NOOP("Text", "The remaining part now starts at edge %1, at tE = %2."),
                "edge"},
    PolygonStep{
        "sooner",
        QT_TRANSLATE_NOOP("Text", "Is the exit at edge %1 before the end of the remaining part?"),
        "edge"},
    PolygonStep{"stop",
                QT_TRANSLATE_NOOP("Text", "The remaining part now ends at edge %1, at tL = %2."),
                "edge"},
    PolygonStep{"missed",
                QT_TRANSLATE_NOOP("Text", "Does the remaining part end before it starts?")},
};
constexpr std::string_view cyrusBeckCode = R"(tE = 0,  tL = 1
for each edge, in order
  N = depth(x1, y1),  M = depth(x2, y2)  #N
  if N < 0 and M < 0: reject  #outside
  if N < 0 or M < 0
    t = N/(N-M)  #t
    if N < 0  #entering
      if t > tE: tE = t  #later start
    else if t < tL: tL = t  #sooner stop
if tE > tL: reject  #missed
if tL < 1: x2, y2 = the point at tL  #move2
if tE > 0: x1, y1 = the point at tE  #move1 contact
accept the line from x1, y1 to x2, y2  #accept)";

constexpr std::array skala{
    PolygonStep{"missed", missed},
    PolygonStep{"edges",
                QT_TRANSLATE_NOOP("Text",
                                  "The corners on either side of the infinite line say where it "
                                  "crosses the polygon: it enters through edge %1 and leaves "
                                  "through edge %2."),
                "i"},
    PolygonStep{"beyond", besideBoth},
    PolygonStep{"end1", oneOutside, "i"},
    PolygonStep{"end2", otherOutside, "j"},
};
constexpr std::string_view skalaCode =
    R"(if all corners lie on one side of the line: reject  #missed reject
i = the edge of entry,  j = the edge of exit  #edges
if x2, y2 is beyond i or x1, y1 is beyond j: reject  #beyond rejectBeyond
if x1, y1 is beyond i  #end1
  x1, y1 = where the line meets edge i  #move1
if x2, y2 is beyond j  #end2
  x2, y2 = where the line meets edge j  #move2
accept the line from x1, y1 to x2, y2  #accept)";

constexpr std::array exact{
    PolygonStep{"besideX", bothBeside},
    PolygonStep{"besideY", bothBelow},
    PolygonStep{"missed", missed},
    PolygonStep{"enter", entersThrough, "enter"},
    PolygonStep{"leave", leavesThrough, "leave"},
    PolygonStep{"beyond", besideBoth},
    PolygonStep{"end1", oneOutside, "enter"},
    PolygonStep{"end2", otherOutside, "leave"},
};
constexpr std::string_view exactCode =
    R"(if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
if all corners lie on one side of the line: reject  #missed reject
enter = the edge of entry  #enter
leave = the edge of exit  #leave
if x2, y2 is beyond enter or x1, y1 is beyond leave: reject  #beyond rejectBeyond
if x1, y1 is beyond enter  #end1
  x1, y1 = where the line meets enter, rounded once  #move1
if x2, y2 is beyond leave  #end2
  x2, y2 = where the line meets leave, rounded once  #move2
accept the line from x1, y1 to x2, y2  #accept)";

constexpr std::array windingNumber{
    PolygonStep{"besideX", bothBeside},
    PolygonStep{"besideY", bothBelow},
    PolygonStep{"most",
                QT_TRANSLATE_NOOP("Text",
                                  "The leftmost corner, as seen along the line, has the side most "
                                  "= %2 (1: left of the line, 0: on it, −1: right of it).")},
    PolygonStep{"enters",
                QT_TRANSLATE_NOOP("Text",
                                  "The infinite line enters through edge %1. Does the line reach "
                                  "this edge?"),
                "i"},
    PolygonStep{"countUp", QT_TRANSLATE_NOOP("Text", "The winding number becomes w = %2.")},
    PolygonStep{"end1", oneOutside, "i"},
    PolygonStep{"leaves",
                QT_TRANSLATE_NOOP("Text",
                                  "The infinite line leaves through edge %1. Does End 2 lie beyond "
                                  "this edge?"),
                "i"},
    PolygonStep{"notEntered", oneOutside, "i"},
    PolygonStep{"countDown", QT_TRANSLATE_NOOP("Text", "The winding number becomes w = %2.")},
    PolygonStep{"missed", QT_TRANSLATE_NOOP("Text", "Is the winding number 0?")},
};
constexpr std::string_view windingNumberCode =
    R"(if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
w = 0,  most = the side of the leftmost corner  #most
for each edge i that the line crosses, in order
  if the line enters at i and x2, y2 is not beyond i  #enters
    w = w+1  #countUp
    if x1, y1 is beyond i: x1, y1 = where the line meets i  #end1 move1
  if the line leaves at i and x2, y2 is beyond i  #leaves
    if x1, y1 is beyond i  #notEntered
      w = w-1  #countDown
    else: x2, y2 = where the line meets i  #move2
if w == 0: reject  #missed reject
accept the line from x1, y1 to x2, y2  #accept)";

// THE CATALOGUE. Another row with a form for polygons has general sentences.
constexpr std::array rows{
    PolygonTeaching{"cyrus-beck", cyrusBeckCode, cyrusBeck},
    PolygonTeaching{"skala", skalaCode, skala},
    PolygonTeaching{"exact", exactCode, exact},
    PolygonTeaching{"winding-number", windingNumberCode, windingNumber},
};

constexpr bool haveLines(const PolygonTeaching& row)
{
    const auto lines = clipping::linesOf(row.code);
    return std::ranges::all_of(row.steps, [&](const PolygonStep& step) {
        return clipping::lineOf(lines, step.label) > 0;
    });
}
static_assert(std::ranges::all_of(rows, haveLines));

const PolygonTeaching* polygonRowOf(const Variant& variant)
{
    const auto* row = std::ranges::find(rows, variant.algorithm->key, &PolygonTeaching::key);
    return row == rows.end() ? nullptr : row;
}

const PolygonStep* polygonRowOf(const Variant& variant, const clipping::Step& step)
{
    const PolygonTeaching* teaching = polygonRowOf(variant);
    if (!teaching)
        return nullptr;
    const auto row = std::ranges::find(teaching->steps, step.label, &PolygonStep::label);
    return row == teaching->steps.end() ? nullptr : &*row;
}

/// The row's text with its numbers.
QString filledIn(const SentenceContext& context, const PolygonStep& row)
{
    const auto value = context.value(context.step.name);
    return Text::tr(row.text)
        .replace(QStringLiteral("%1"), QString::number(polygonEdgeOf(context)))
        .replace(QStringLiteral("%2"), words::number(value.value_or(0)));
}

struct MovedEnd {
    int number;
    Point to;
};
MovedEnd movedEnd(const SentenceContext& context)
{
    const auto& before = context.before ? context.before->segment : context.tracedLine.line;
    const auto& now = context.step.segment;
    return before.a != now.a ? MovedEnd{1, now.a} : MovedEnd{2, now.b};
}

QString polygonCut(const SentenceContext& context)
{
    const auto [number, to] = movedEnd(context);
    return Text::tr("%1 is cut at edge %2: it moves to %3.")
        .arg(words::end(number))
        .arg(polygonEdgeOf(context))
        .arg(words::point(to));
}

} // namespace

std::string_view polygonCode(const Variant& variant)
{
    const PolygonTeaching* row = polygonRowOf(variant);
    return row ? row->code : clipping::codeOf(*variant.algorithm, variant.form);
}

QString polygonSentence(const SentenceContext& context)
{
    const PolygonStep* row = polygonRowOf(context.tracedLine.variant, context.step);
    const What what = context.step.what;
    if (what == What::Cut)
        return polygonCut(context);
    if (what == What::Accept)
        return words::accepted(context);
    if (what == What::Reject)
        return Text::tr("The line is rejected: nothing is visible.");
    if (!row)
        return generalSentence(context);
    const QString text = filledIn(context, *row);
    return what == What::Test ? text + u' ' + (context.holds() ? Text::tr("Yes.") : Text::tr("No."))
                              : text;
}

std::size_t polygonEdgeOf(const SentenceContext& context)
{
    if (context.step.what == What::Cut)
        return polygonEdgeAt(movedEnd(context).to, context.tracedLine.corners);
    const PolygonStep* row = polygonRowOf(context.tracedLine.variant, context.step);
    const auto number = row && row->edge ? context.known(row->edge) : std::nullopt;
    return number ? std::size_t(*number) : 0;
}

} // namespace app
