// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/handles.h"

#include <QString>

#include <array>
#include <optional>

namespace app {

/// The kind of a number of a gesture.
enum class Quantity : std::uint8_t { Length, Angle, Coordinate };

/// The two numbers of a gesture; nothing: the pointer decides.
using Held = std::array<std::optional<double>, 2>;

/// One way to measure a gesture that leads from one point to another by two numbers: length and
/// angle, width and height, x and y. Lengths are in user units, angles in degrees.
struct GestureMeasure {
    struct Field {
        QString name;
        Quantity quantity;
    };
    std::array<Field, 2> fields;
    std::array<double, 2> (*values)(const Point& from, const Point& to);
    /// The end whose numbers are those that are held, exactly, and otherwise the pointer's.
    Point (*end)(const Point& from, const Point& pointer, const Held& held);
    /// Whether a typed "10,20" counts from `from`; false: from the origin of coordinates.
    bool relative;
};

/// For lines and moves. A held angle keeps the end on its ray.
const GestureMeasure& lengthAndAngle();
/// For shapes dragged from corner to corner. A positive width or height goes to the pointer's side,
/// a negative one to the left or up. Square: both are the held one, otherwise the longer one.
/// Centre: the gesture begins in the middle of the shape.
const GestureMeasure& widthAndHeight(Proportion proportion = Proportion::Free,
                                     Anchor anchor = Anchor::Opposite);
/// For a first point, measured from the origin of coordinates.
const GestureMeasure& position();

/// The number of the first length that is 0, so that nothing is drawn. Coordinates may be 0.
std::optional<std::size_t> firstZeroLength(const GestureMeasure& measure, const Point& from,
                                           const Point& to);

} // namespace app
