// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_numbers.h"

#include "app/base/text.h"
#include "app/commands/move_objects.h"
#include "app/document/direction.h"
#include "app/drawing/transformation.h"
#include "app/session/selection_frame.h"
#include "app/view/ruler.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace app {
namespace {

using SelectionValue = std::optional<double>;
using Map = std::optional<AffineMap>;
using Frame = SelectionFrame;

constexpr std::size_t mostMeasured = 600'000; // lines: some 3 ms
constexpr std::size_t linesForRange = 30;     // that are measured while a range is found

/// The only selected object, if it is a line.
std::optional<clipping::Segment> onlyLine(const Session& session)
{
    const ObjectRanges& selection = session.selection();
    if (selection.size() != 1)
        return std::nullopt;
    return session.now().objects()[selection.first()].singleLine();
}

/// In radians, from x towards y.
double turnOf(const Recipe& recipe)
{
    struct Turn {
        double operator()(std::monostate) const { return 0; }
        double operator()(const StarRecipe&) const { return 0; } // no corner is the first to people
        double operator()(const RectangleRecipe& r) const { return r.turn; }
        double operator()(const EllipseRecipe& e) const { return e.turn; }
        double operator()(const TextRecipe& t) const { return t.turn; }
    };
    return std::visit(Turn{}, recipe);
}

std::optional<Point> reference(const Session& session, const Frame& frame)
{
    const auto own = selectionFrame(session);
    return own ? std::optional(outOfFrame(*own, placeOf(frame.reference, own->box))) : std::nullopt;
}

template <int axis>
SelectionValue selectionPlace(const Session& session, const Frame& frame)
{
    const auto at = reference(session, frame);
    const Point origin = originOf(session.now().page(), session.display().unit);
    return at ? SelectionValue((*at)[axis] - origin[axis]) : std::nullopt;
}

template <int axis>
Map moveTo(const Session& session, const Frame& frame, double value)
{
    const auto old = selectionPlace<axis>(session, frame);
    Point by(0);
    by[axis] = value - old.value_or(value);
    return old ? Map(translation(by)) : std::nullopt;
}

template <int axis>
SelectionValue side(const Session& session, const Frame&)
{
    const auto own = selectionFrame(session);
    return own ? SelectionValue(own->box.max[axis] - own->box.min[axis]) : std::nullopt;
}

template <int axis>
Map resizeTo(const Session& session, const Frame& frame, double value)
{
    const auto old = side<axis>(session, frame);
    if (!old || *old == 0 || !(value > 0))
        return std::nullopt;
    Point factors(1);
    factors[axis] = value / *old;
    if (frame.keepsRatio)
        factors = Point(factors[axis]);
    return scalingAlong(selectionFrame(session)->angle, factors, *reference(session, frame));
}

/// Some objects remember how they are turned; of everything else the angle is the turn that is
/// typed.
SelectionValue selectionAngle(const Session& session, const Frame&)
{
    if (const auto line = onlyLine(session))
        return degreesOf(line->b - line->a);
    if (!session.selectionBounds())
        return std::nullopt;
    return degreesOf(turnedBy({1, 0}, turnOf(onlyRecipe(session))));
}

Map turnTo(const Session& session, const Frame& frame, double value)
{
    const auto at = reference(session, frame);
    if (!at)
        return std::nullopt;
    const auto line = onlyLine(session);
    return rotation(value - selectionAngle(session, frame).value_or(0), line ? line->a : *at);
}

/// The skew that is typed: no object remembers how it was skewed.
SelectionValue skew(const Session& session, const Frame&)
{
    return session.selectionBounds() ? SelectionValue(0) : std::nullopt;
}

Map skewBy(const Session& session, const Frame& frame, double value)
{
    const double height = side<1>(session, frame).value_or(0);
    if (!(height > 0) || !(std::abs(value) <= mostSkew))
        return std::nullopt;
    return horizontalSkew(value, *reference(session, frame));
}

/// Of all lines and chords together. Empty for so many that the program would wait for them.
SelectionValue lineLength(const Session& session, const Frame&)
{
    const auto ranges = session.selection().ranges();
    if (ranges.empty())
        return std::nullopt;
    const SceneLines& lines = session.scene.lines();
    std::size_t left = mostMeasured;
    double sum = 0;
    for (const auto& [begin, past] : ranges) {
        const std::size_t from = lines.firstLineOf(begin), to = lines.firstLineOf(past);
        const std::size_t work = to - from + linesForRange;
        if (work > left)
            return std::nullopt;
        left -= work;
        lines.forEachPart(from, to, [&](std::size_t run, std::size_t first, std::size_t end) {
            for (const clipping::Segment& s :
                 lines.runs()[run].segments.subspan(first, end - first))
                sum += glm::distance(s.a, s.b);
        });
    }
    return sum;
}

Map lengthenTo(const Session& session, const Frame& frame, double value)
{
    const auto old = lineLength(session, frame);
    if (!old || *old == 0 || !(value > 0))
        return std::nullopt;
    const auto line = onlyLine(session);
    return scaling(Point(value / *old), line ? line->a : *reference(session, frame));
}

} // namespace

std::span<const SelectionNumber> selectionNumbers()
{
    const QString tooLarge = Text::tr("This number is too large.");
    static const std::array all{
        SelectionNumber{"x", Text::tr("X"), Text::tr("X"), Quantity::Coordinate, selectionPlace<0>,
                        moveTo<0>, tooLarge},
        SelectionNumber{"y", Text::tr("Y"), Text::tr("Y"), Quantity::Coordinate, selectionPlace<1>,
                        moveTo<1>, tooLarge},
        SelectionNumber{"w", Text::tr("W"), Text::tr("Width"), Quantity::Length, side<0>,
                        resizeTo<0>,
                        Text::tr("The width must be more than 0, and a vertical line has none.")},
        SelectionNumber{
            "h", Text::tr("H"), Text::tr("Height"), Quantity::Length, side<1>, resizeTo<1>,
            Text::tr("The height must be more than 0, and a horizontal line has none.")},
        SelectionNumber{"angle", Text::tr("∠"), Text::tr("Angle"), Quantity::Angle, selectionAngle,
                        turnTo, tooLarge},
        SelectionNumber{
            "skew", Text::tr("▱"), Text::tr("Skew"), Quantity::Angle, skew, skewBy,
            Text::tr("The skew must be between −%1° and %1°, and a horizontal line has none.")
                .arg(mostSkew)},
        SelectionNumber{"length", Text::tr("L"), Text::tr("Length"), Quantity::Length, lineLength,
                        lengthenTo,
                        Text::tr("The length must be more than 0. A point has none, and that of "
                                 "hundreds of thousands of lines is not measured.")},
    };
    return all;
}

std::optional<QString> setSelectionNumber(Session& session, const SelectionNumber& number,
                                          const SelectionFrame& frame, double value,
                                          Merging merging)
{
    const Map map = number.map(session, frame, value);
    if (!map || !map->isFinite() || !(map->scale() > 0))
        return number.refusal;
    if (*map == AffineMap{.from = map->from, .to = map->from})
        return std::nullopt;
    const QString text = Text::tr("Set %1").arg(number.name.toLower());
    session.history.push(new TransformObjects(session.document, session.selection(), *map,
                                              session.arrange.strokes, text, merging));
    return std::nullopt;
}

} // namespace app
