// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/gesture_measure.h"

#include "app/base/text.h"
#include "app/document/affine_map.h"
#include "app/document/direction.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// A vector of this length in a vector's direction; to the right, if that is zero.
Point ofLength(const Point& vector, double length)
{
    const double largest = std::max(std::abs(vector.x), std::abs(vector.y));
    if (largest == 0)
        return {length, 0};
    if (vector.x == 0 || vector.y == 0) // exactly
        return vector / largest * length;
    return glm::normalize(vector / largest) * length;
}

template <bool centre>
Point endOfLengthAndAngle(const GestureStart& start, const Point& pointer, const Held& held)
{
    constexpr double share = centre ? 0.5 : 1; // of the length, from where the gesture begins
    const Point& from = start.from;
    const auto &length = held[0], &angle = held[1];
    const Point vector = pointer - from;
    if (!angle)
        return length ? from + ofLength(vector, *length * share) : pointer;
    const Point direction = directionOf(*angle);
    const double reach = length ? *length * share : std::max(0.0, glm::dot(vector, direction));
    return from + direction * reach;
}

/// Where a side ends that begins at `from`.
double endOfSide(double from, double pointer, double side)
{
    return pointer < from && side > 0 ? from - side : from + side;
}

template <bool square, bool centre>
Point endOfBox(const GestureStart& start, const Point& pointer, const Held& held)
{
    const Point& from = start.from;
    constexpr double share = centre ? 0.5 : 1; // of a side, from where the gesture begins
    Held sides = held;
    if constexpr (square) {
        const Point size = glm::abs(pointer - from) / share;
        const double side = held[0].value_or(held[1].value_or(std::max(size.x, size.y)));
        sides = {side, side};
    }
    Point end = pointer;
    for (int axis = 0; axis < 2; ++axis)
        if (sides[std::size_t(axis)])
            end[axis] = endOfSide(from[axis], pointer[axis], *sides[std::size_t(axis)] * share);
    return end;
}

std::vector<GestureMeasure::Field> sides()
{
    return {{Text::tr("Width"), Quantity::Length}, {Text::tr("Height"), Quantity::Length}};
}

std::vector<GestureMeasure::Field> with(std::vector<GestureMeasure::Field> fields,
                                        GestureMeasure::Field&& kept)
{
    kept.kept = true;
    fields.push_back(std::move(kept));
    return fields;
}

template <bool square, bool centre>
GestureMeasure boxMeasure(std::vector<GestureMeasure::Field> fields)
{
    return {std::move(fields),
            [](const GestureStart& start, const Point& to) -> Numbers {
                const Point size = glm::abs(to - start.from) * (centre ? 2.0 : 1.0);
                return {size.x, size.y};
            },
            endOfBox<square, centre>,
            GestureMeasure::Points::Relative,
            nullptr,
            square};
}

template <int axis, bool centre>
GestureMeasure sideMeasure()
{
    constexpr double share = centre ? 0.5 : 1;
    return {{{axis == 0 ? Text::tr("Width") : Text::tr("Height"), Quantity::Length}},
            [](const GestureStart& start, const Point& to) -> Numbers {
                return {std::abs(to[axis] - start.from[axis]) / share, 0};
            },
            [](const GestureStart& start, const Point& pointer, const Held& held) {
                Point end = pointer;
                if (held[0])
                    end[axis] = endOfSide(start.from[axis], pointer[axis], *held[0] * share);
                return end;
            },
            GestureMeasure::Points::Refused};
}

template <bool centre = false>
GestureMeasure polar(std::vector<GestureMeasure::Field> fields)
{
    return {std::move(fields),
            [](const GestureStart& start, const Point& to) -> Numbers {
                const double length = glm::length(to - start.from) * (centre ? 2 : 1);
                return {length, degreesOf(to - start.from)};
            },
            endOfLengthAndAngle<centre>, GestureMeasure::Points::Relative,
            [](const GestureStart& start, const Point& pointer) {
                return turnedToStep(start.from, pointer);
            }};
}

std::vector<GestureMeasure::Field> radius()
{
    return {{Text::tr("Radius"), Quantity::Length}, {Text::tr("Angle"), Quantity::Angle}};
}

using Boxes = std::array<GestureMeasure, 4>;

Boxes boxMeasures(const std::vector<GestureMeasure::Field>& fields)
{
    return {boxMeasure<false, false>(fields), boxMeasure<true, false>(fields),
            boxMeasure<false, true>(fields), boxMeasure<true, true>(fields)};
}

const GestureMeasure& chosen(const Boxes& boxes, Proportion proportion, Anchor anchor)
{
    return boxes[(proportion == Proportion::Square ? 1U : 0U)
                 + (anchor == Anchor::Centre ? 2U : 0U)];
}

} // namespace

const GestureMeasure& sideLength(int axis, Anchor anchor)
{
    static const std::array measures{sideMeasure<0, false>(), sideMeasure<1, false>(),
                                     sideMeasure<0, true>(), sideMeasure<1, true>()};
    return measures[std::size_t(axis) + (anchor == Anchor::Centre ? 2 : 0)];
}

const GestureMeasure& lengthAndAngle(Anchor anchor)
{
    static const std::vector<GestureMeasure::Field> fields{{Text::tr("Length"), Quantity::Length},
                                                           {Text::tr("Angle"), Quantity::Angle}};
    static const GestureMeasure fromEnd = polar(fields), fromMiddle = polar<true>(fields);
    return anchor == Anchor::Centre ? fromMiddle : fromEnd;
}

const GestureMeasure& radiusAndAngle()
{
    static const GestureMeasure measure = polar(radius());
    return measure;
}

const GestureMeasure& polygonMeasure()
{
    static const GestureMeasure measure =
        polar(with(radius(), {Text::tr("Corners"), Quantity::Count}));
    return measure;
}

const GestureMeasure& starMeasure()
{
    static const GestureMeasure measure =
        polar(with(with(radius(), {Text::tr("Points"), Quantity::Count}),
                   {Text::tr("Inner"), Quantity::Share, 1}));
    return measure;
}

const GestureMeasure& widthAndHeight(Proportion proportion, Anchor anchor)
{
    static const Boxes boxes = boxMeasures(sides());
    return chosen(boxes, proportion, anchor);
}

const GestureMeasure& widthHeightAndRadius(Proportion proportion, Anchor anchor)
{
    static const Boxes boxes = boxMeasures(with(sides(), {Text::tr("Radius"), Quantity::Length}));
    return chosen(boxes, proportion, anchor);
}

const GestureMeasure& position()
{
    static const GestureMeasure measure{
        {{Text::tr("X"), Quantity::Coordinate}, {Text::tr("Y"), Quantity::Coordinate}},
        [](const GestureStart& start, const Point& to) -> Numbers {
            return {to.x - start.from.x, to.y - start.from.y};
        },
        [](const GestureStart& start, const Point& pointer, const Held& held) {
            return Point(held[0] ? start.from.x + *held[0] : pointer.x,
                         held[1] ? start.from.y + *held[1] : pointer.y);
        },
        GestureMeasure::Points::Absolute};
    return measure;
}

Point turnedPointer(const GestureStart& start, double degrees)
{
    return rotation(degrees, start.from)(start.pointer);
}

std::optional<std::size_t> firstZero(const GestureMeasure& measure, const GestureStart& start,
                                     const Point& to)
{
    const auto values = measure.values(start, to);
    for (std::size_t i = 0; i < measure.fields.size(); ++i) {
        const auto& [name, quantity, most, kept] = measure.fields[i];
        if (!kept && (quantity == Quantity::Length || quantity == Quantity::Factor)
            && values[i] == 0)
            return i;
    }
    return std::nullopt;
}

} // namespace app
