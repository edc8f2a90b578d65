// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/frame_measures.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>

namespace app {
namespace {

// The directions of width and height.
std::array<Point, 2> axesOf(const GestureStart& start)
{
    const Point x = glm::normalize(start.pointer - start.from);
    return {x, Point(-x.y, x.x)};
}

Point intoAxes(const GestureStart& start, const Point& p)
{
    const auto [x, y] = axesOf(start);
    return {glm::dot(p - start.from, x), glm::dot(p - start.from, y)};
}

Point outOfAxes(const GestureStart& start, const Point& p)
{
    const auto [x, y] = axesOf(start);
    return start.from + x * p.x + y * p.y;
}

// The measure of the upright rectangle, in the directions of the rotated one.
template <const GestureMeasure& (*upright)()>
GestureMeasure rotated()
{
    GestureMeasure measure = upright();
    measure.values = [](const GestureStart& start, const Point& to) {
        return upright().values({Point(0)}, intoAxes(start, to));
    };
    measure.end = [](const GestureStart& start, const Point& pointer, const Held& held) {
        const Point end = upright().end({Point(0)}, intoAxes(start, pointer), held);
        return outOfAxes(start, end);
    };
    measure.points = GestureMeasure::Points::Refused;
    return measure;
}

template <Anchor anchor>
const GestureMeasure& box()
{
    return widthAndHeight(Proportion::Free, anchor);
}

template <int axis, Anchor anchor>
const GestureMeasure& side()
{
    return sideLength(axis, anchor);
}

} // namespace

const GestureMeasure& rotatedWidthAndHeight(Anchor anchor)
{
    static const std::array measures{rotated<box<Anchor::Opposite>>(),
                                     rotated<box<Anchor::Centre>>()};
    return measures[anchor == Anchor::Centre ? 1 : 0];
}

const GestureMeasure& rotatedSideLength(int axis, Anchor anchor)
{
    static const std::array measures{
        rotated<side<0, Anchor::Opposite>>(), rotated<side<1, Anchor::Opposite>>(),
        rotated<side<0, Anchor::Centre>>(), rotated<side<1, Anchor::Centre>>()};
    return measures[std::size_t(axis) + (anchor == Anchor::Centre ? 2 : 0)];
}

} // namespace app
