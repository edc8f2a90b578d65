// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/polygon.h"

#include "app/base/text.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/page.h"
#include "app/teaching/sentences/words.h"

#include <algorithm>
#include <array>

namespace app {

using clipping::What;

namespace {

/// A step of the library by its line in the pseudo-code for windows, and how it is shown: a line
/// of the code here, and a question or sentence in which %1 is the number of the edge that the
/// variable `edge` names, and %2 the assigned value.
struct PolygonStep {
    int told;
    int line;
    const char* text = nullptr; ///< null: the general words
    const char* edge = nullptr;
};

struct PolygonTeaching {
    std::string_view key;
    const char* code;
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
        4, 3,
        QT_TRANSLATE_NOOP(
            "Text", "At edge %1, N = %2 for End 1 (N < 0: it lies beyond the line of this edge)."),
        "edge"},
    PolygonStep{6, 4, QT_TRANSLATE_NOOP("Text", "Do both ends lie beyond edge %1?"), "edge"},
    PolygonStep{8, 6,
                QT_TRANSLATE_NOOP("Text",
                                  "The line crosses the line of edge %1 at t = %2 (0 is End 1, 1 "
                                  "is End 2)."),
                "edge"},
    PolygonStep{9, 7, QT_TRANSLATE_NOOP("Text", "Does the line enter at edge %1?"), "edge"},
    PolygonStep{
        10, 8,
        QT_TRANSLATE_NOOP("Text", "Is the entry at edge %1 after the start of the remaining part?"),
        "edge"},
    PolygonStep{11, 8,
                QT_TRANSLATE_NOOP("Text", "The remaining part now starts at edge %1, at tE = %2."),
                "edge"},
    PolygonStep{
        12, 9,
        QT_TRANSLATE_NOOP("Text", "Is the exit at edge %1 before the end of the remaining part?"),
        "edge"},
    PolygonStep{13, 9,
                QT_TRANSLATE_NOOP("Text", "The remaining part now ends at edge %1, at tL = %2."),
                "edge"},
    PolygonStep{14, 10, QT_TRANSLATE_NOOP("Text", "Does the remaining part end before it starts?")},
    PolygonStep{16, 11},
    PolygonStep{20, 12},
    PolygonStep{22, 12},
    PolygonStep{25, 13},
};
constexpr auto cyrusBeckCode = "tE = 0,  tL = 1\n"
                               "for each edge, in order\n"
                               "  N = depth(x1, y1),  M = depth(x2, y2)\n"
                               "  if N < 0 and M < 0: reject\n"
                               "  if N < 0 or M < 0\n"
                               "    t = N/(N-M)\n"
                               "    if N < 0\n"
                               "      if t > tE: tE = t\n"
                               "    else if t < tL: tL = t\n"
                               "if tE > tL: reject\n"
                               "if tL < 1: x2, y2 = the point at tL\n"
                               "if tE > 0: x1, y1 = the point at tE\n"
                               "accept the line from x1, y1 to x2, y2";

constexpr std::array skala{
    PolygonStep{22, 1, missed},
    PolygonStep{23, 1},
    PolygonStep{24, 2,
                QT_TRANSLATE_NOOP("Text",
                                  "The corners on either side of the infinite line say where it "
                                  "crosses the polygon: it enters through edge %1 and leaves "
                                  "through edge %2."),
                "i"},
    PolygonStep{4, 3, besideBoth},
    PolygonStep{5, 3},
    PolygonStep{27, 4, oneOutside, "i"},
    PolygonStep{28, 5},
    PolygonStep{25, 6, otherOutside, "j"},
    PolygonStep{26, 7},
    PolygonStep{29, 8},
};
constexpr auto skalaCode = "if all corners lie on one side of the line: reject\n"
                           "i = the edge of entry,  j = the edge of exit\n"
                           "if x2, y2 is beyond i or x1, y1 is beyond j: reject\n"
                           "if x1, y1 is beyond i\n"
                           "  x1, y1 = where the line meets edge i\n"
                           "if x2, y2 is beyond j\n"
                           "  x2, y2 = where the line meets edge j\n"
                           "accept the line from x1, y1 to x2, y2";

constexpr std::array exact{
    PolygonStep{1, 1, bothBeside},
    PolygonStep{2, 2},
    PolygonStep{3, 3, bothBelow},
    PolygonStep{4, 4},
    PolygonStep{13, 5, missed},
    PolygonStep{14, 5},
    PolygonStep{9, 6, entersThrough, "enter"},
    PolygonStep{11, 7, leavesThrough, "leave"},
    PolygonStep{15, 8, besideBoth},
    PolygonStep{16, 8},
    PolygonStep{17, 9, oneOutside, "enter"},
    PolygonStep{18, 10},
    PolygonStep{21, 11, otherOutside, "leave"},
    PolygonStep{22, 12},
    PolygonStep{25, 13},
};
constexpr auto exactCode = "if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)\n"
                           "  reject\n"
                           "if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)\n"
                           "  reject\n"
                           "if all corners lie on one side of the line: reject\n"
                           "enter = the edge of entry\n"
                           "leave = the edge of exit\n"
                           "if x2, y2 is beyond enter or x1, y1 is beyond leave: reject\n"
                           "if x1, y1 is beyond enter\n"
                           "  x1, y1 = where the line meets enter, rounded once\n"
                           "if x2, y2 is beyond leave\n"
                           "  x2, y2 = where the line meets leave, rounded once\n"
                           "accept the line from x1, y1 to x2, y2";

constexpr std::array windingNumber{
    PolygonStep{7, 1, bothBeside},
    PolygonStep{8, 2},
    PolygonStep{9, 3, bothBelow},
    PolygonStep{10, 4},
    PolygonStep{4, 5,
                QT_TRANSLATE_NOOP("Text",
                                  "The leftmost corner, as seen along the line, has the side most "
                                  "= %2 (1: left of the line, 0: on it, −1: right of it).")},
    PolygonStep{15, 7,
                QT_TRANSLATE_NOOP("Text",
                                  "The infinite line enters through edge %1. Does the line reach "
                                  "this edge?"),
                "i"},
    PolygonStep{16, 8, QT_TRANSLATE_NOOP("Text", "The winding number becomes w = %2.")},
    PolygonStep{17, 9, oneOutside, "i"},
    PolygonStep{19, 10,
                QT_TRANSLATE_NOOP("Text",
                                  "The infinite line leaves through edge %1. Does End 2 lie beyond "
                                  "this edge?"),
                "i"},
    PolygonStep{20, 11, oneOutside, "i"},
    PolygonStep{21, 12, QT_TRANSLATE_NOOP("Text", "The winding number becomes w = %2.")},
    PolygonStep{24, 14, QT_TRANSLATE_NOOP("Text", "Is the winding number 0?")},
    PolygonStep{25, 14},
    PolygonStep{18, 9},
    PolygonStep{23, 13},
    PolygonStep{26, 15},
};
constexpr auto windingNumberCode = "if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)\n"
                                   "  reject\n"
                                   "if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)\n"
                                   "  reject\n"
                                   "w = 0,  most = the side of the leftmost corner\n"
                                   "for each edge i that the line crosses, in order\n"
                                   "  if the line enters at i and x2, y2 is not beyond i\n"
                                   "    w = w+1\n"
                                   "    if x1, y1 is beyond i: x1, y1 = where the line meets i\n"
                                   "  if the line leaves at i and x2, y2 is beyond i\n"
                                   "    if x1, y1 is beyond i\n"
                                   "      w = w-1\n"
                                   "    else: x2, y2 = where the line meets i\n"
                                   "if w == 0: reject\n"
                                   "accept the line from x1, y1 to x2, y2";

// THE CATALOGUE. Another row with a form for polygons has general sentences.
constexpr std::array rows{
    PolygonTeaching{"cyrus-beck", cyrusBeckCode, cyrusBeck},
    PolygonTeaching{"skala", skalaCode, skala},
    PolygonTeaching{"exact", exactCode, exact},
    PolygonTeaching{"winding-number", windingNumberCode, windingNumber},
};

const PolygonTeaching* rowOf(const Variant& variant)
{
    const auto* row = std::ranges::find(rows, variant.algorithm->key, &PolygonTeaching::key);
    return row == rows.end() ? nullptr : row;
}

const PolygonStep* rowOf(const Variant& variant, const clipping::Step& step)
{
    const PolygonTeaching* teaching = rowOf(variant);
    if (!teaching)
        return nullptr;
    const auto row = std::ranges::find(teaching->steps, step.line, &PolygonStep::told);
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

QStringList polygonCode(const Variant& variant)
{
    const PolygonTeaching* row = rowOf(variant);
    return row ? QString::fromLatin1(row->code).split(u'\n') : codeOf(variant);
}

int polygonLine(const Variant& variant, const clipping::Step& step)
{
    const PolygonStep* row = rowOf(variant, step);
    return row ? row->line : rowOf(variant) ? 0 : step.line;
}

QString polygonSentence(const SentenceContext& context)
{
    const PolygonStep* row = rowOf(context.tracedLine.variant, context.step);
    const What what = context.step.what;
    if (what == What::Cut)
        return polygonCut(context);
    if (what == What::Accept)
        return words::accepted(context);
    if (what == What::Reject)
        return Text::tr("The line is rejected: nothing is visible.");
    if (!row || !row->text)
        return generalSentence(context);
    const QString text = filledIn(context, *row);
    return what == What::Test ? text + u' ' + (context.holds() ? Text::tr("Yes.") : Text::tr("No."))
                              : text;
}

std::size_t polygonEdgeOf(const SentenceContext& context)
{
    if (context.step.what == What::Cut)
        return polygonEdgeAt(movedEnd(context).to, context.tracedLine.corners);
    const PolygonStep* row = rowOf(context.tracedLine.variant, context.step);
    const auto number = row && row->edge ? context.known(row->edge) : std::nullopt;
    return number ? std::size_t(*number) : 0;
}

} // namespace app
