// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/practice/kinds/kinds.h"
#include "app/teaching/sentences/words.h"
#include "clipping/outcode.h"

#include <array>

namespace app {

namespace {

using clipping::Edge;

constexpr std::array edgesOfBits{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

/// The variable that this step sets, of those that are planned.
const clipping::NamedValue* setHere(const MoveContext& context)
{
    for (const clipping::NamedValue& value : context.traced().values)
        if (isWordOf(value.name, context.planned.variable))
            return &value;
    return nullptr;
}

/// "x = −160, xmin = −100".
QString numbersAt(const Point& p, Edge edge, const clipping::Window& window)
{
    static constexpr std::array names{"", "xmin", "xmax", "ymin", "ymax"};
    const bool isX = clipping::axisOf(edge) == 0;
    return QStringLiteral("%1 = %2, %3 = %4")
        .arg(words::axisName(edge), words::number(isX ? p.x : p.y),
             QLatin1String(names.at(std::size_t(edge))),
             words::number(clipping::levelOf(edge, window)));
}

/// "left of the window: −160 < −100", for every bit.
QString comparisons(const Point& p, const clipping::Window& window, unsigned bits, YAxis y)
{
    QStringList all;
    for (std::size_t k = edgesOfBits.size(); k-- > 0;)
        if (bits >> k & 1U)
            all << Text::tr("%1: %2").arg(words::beyond(edgesOfBits[k], y),
                                          words::compared(p, edgesOfBits[k], window));
    return all.join(QStringLiteral("; "));
}

unsigned reversed(unsigned code)
{
    return (code & 1U) << 3 | (code & 2U) << 1 | (code & 4U) >> 1 | (code & 8U) >> 3;
}
unsigned sidesSwapped(unsigned code) { return (code & 12U) | (code & 1U) << 1 | (code & 2U) >> 1; }
unsigned levelsSwapped(unsigned code) { return (code & 3U) | (code & 4U) << 1 | (code & 8U) >> 1; }

void addMistakesOfOutcodes(Move& move, const Point& p, const Point& other, const TracedLine& traced)
{
    const auto code = unsigned(move.right);
    const bool up = traced.y == YAxis::Up;
    addMistake(
        move, "left-right", sidesSwapped(code),
        Text::tr("Left and right are exchanged. Compare x = %1 with xmin = %2 and xmax = %3.")
            .arg(words::number(p.x), words::number(traced.window.min.x),
                 words::number(traced.window.max.x)));
    addMistake(move, "above-below", levelsSwapped(code),
               (up ? Text::tr("Above and below are exchanged: y points up. Compare y = %1 with "
                              "ymin = %2 and ymax = %3.")
                   : Text::tr("Above and below are exchanged: y points down. Compare y = %1 with "
                              "ymin = %2 and ymax = %3."))
                   .arg(words::number(p.y), words::number(traced.window.min.y),
                        words::number(traced.window.max.y)));
    addMistake(move, "order", reversed(code),
               Text::tr("These are the bits in the reverse order. From left to right they are: %1.")
                   .arg(outcodeBits()));
    addMistake(
        move, "other-end", clipping::outcodeOf(other, traced.window),
        Text::tr("That is the code of the other end. This end is at %1.").arg(words::point(p)));
    if (code != 0)
        addMistake(move, "inside", 0,
                   Text::tr("0000 means inside the window, and this end is outside. Compare its "
                            "coordinates with the edges."));
    for (std::size_t k = 0; k < edgesOfBits.size(); ++k) {
        const unsigned bit = 1U << k;
        if (code & bit)
            addMistake(move, "missing", code & ~bit,
                       Text::tr("A bit is missing: an end can lie beyond two edges. Is this one "
                                "%1, too? %2")
                           .arg(words::beyond(edgesOfBits[k], traced.y),
                                numbersAt(p, edgesOfBits[k], traced.window)));
        else
            addMistake(move, "extra", code | bit,
                       Text::tr("One bit too many is 1. Is the end %1? %2")
                           .arg(words::beyond(edgesOfBits[k], traced.y),
                                numbersAt(p, edgesOfBits[k], traced.window)));
    }
    for (unsigned wrong = 0; wrong < 16; ++wrong)
        if ((wrong & 3U) == 3 || (wrong & 12U) == 12)
            addMistake(move, "opposite", wrong,
                       Text::tr("No point is beyond two opposite edges. At most one of left and "
                                "right is 1, and at most one of above and below."));
}

Move outcodeMove(const MoveContext& context, const clipping::NamedValue& value)
{
    const bool first = value.name.find('1') != std::string_view::npos;
    const TracedLine& traced = context.tracedLine;
    const clipping::Segment& left = context.traced().segment;
    const Point p = first ? left.a : left.b, other = first ? left.b : left.a;
    const int end = first ? 1 : 2;
    const auto code = unsigned(value.value);
    const bool moved = p != (first ? traced.line.a : traced.line.b);
    Move move{.prompt =
                  moved
                      ? Text::tr("Set the outcode of the new End %1, at %2.")
                            .arg(end)
                            .arg(words::point(p))
                      : Text::tr("Set the outcode of End %1, at %2.").arg(end).arg(words::point(p)),
              .brief = Text::tr("Outcode of End %1").arg(end),
              .right = double(code),
              .bits = outcodeBits().split(QStringLiteral(", ")),
              .hint = Text::tr("Ask one question for each bit, in this order: %1. A yes is 1, a no "
                               "is 0.")
                          .arg(outcodeBits())};
    move.reason = code == 0
                      ? Text::tr("End %1 is inside the window or on its edge: 0000.").arg(end)
                      : Text::tr("End %1 is %2: %3.")
                            .arg(end)
                            .arg(comparisons(p, traced.window, code, traced.y), outcodeText(code));
    addMistakesOfOutcodes(move, p, other, traced);
    return move;
}

/// Skala's pattern: which corners of the window are on the line or to its left.
Move cornersMove(const clipping::NamedValue& value)
{
    const auto c = unsigned(value.value);
    Move move{.prompt = Text::tr("Set c: a bit is 1 if its corner is on the line or to its left."),
              .brief = Text::tr("Pattern of the corners"),
              .right = double(c),
              .bits = {Text::tr("corner 3"), Text::tr("corner 2"), Text::tr("corner 1"),
                       Text::tr("corner 0")},
              .hint = Text::tr("Read c[0], c[1], c[2] and c[3] in the table of variables. c[3] is "
                               "the bit at the left.")};
    move.reason =
        Text::tr("c[3], c[2], c[1], c[0] are the bits from left to right: %1.").arg(outcodeText(c));
    addMistake(
        move, "order", reversed(c),
        Text::tr("These are the bits in the reverse order: c[0] counts 1, so it is the bit at "
                 "the right."));
    addMistake(
        move, "sides", ~c & 15U,
        Text::tr("The sides are exchanged: 1 is for corners to the left of the line, as seen "
                 "from End 1 to End 2."));
    return move;
}

std::optional<Move> makeBits(const MoveContext& context)
{
    const clipping::NamedValue* value = setHere(context);
    if (!value)
        return std::nullopt;
    Move move = value->name == "c" ? cornersMove(*value) : outcodeMove(context, *value);
    move.name = latin(value->name);
    move.chance = 1.0 / 16;
    return move;
}

QString bitsText(const Move&, double answer, YAxis) { return outcodeText(unsigned(answer)); }

} // namespace

const MoveMaker bitsMaker{MoveKind::Bits, makeBits, bitsText};

} // namespace app
