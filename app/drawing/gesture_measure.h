// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/typed_entry.h"
#include "app/view/handles.h"

#include <QString>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace app {

/// The numbers of a gesture, in the order of its fields; those without a field are 0.
constexpr std::size_t mostNumbers = 4;
using Numbers = std::array<double, mostNumbers>;
/// Nothing: the pointer decides, or the number stays as it was.
using Held = std::array<std::optional<double>, mostNumbers>;

/// Where a gesture begins.
struct GestureStart {
    Point from;      ///< what stays: the first point, or the pivot
    Point pointer{}; ///< where the pointer was; only rotating, scaling and skewing refer to it
    friend bool operator==(const GestureStart&, const GestureStart&) = default;
};

/// One way to measure a gesture by numbers: length and angle, width and height, x and y, an angle
/// alone. Lengths are in user units, angles in degrees.
struct GestureMeasure {
    struct Field {
        QString name;
        Quantity quantity;
        double most = std::numeric_limits<double>::infinity(); ///< of the number without its sign
        bool kept = false; ///< the pointer does not steer it: it stays as it was (Gauge::kept)
    };
    std::vector<Field> fields; ///< one or two that the pointer steers, then those that are kept
    Numbers (*values)(const GestureStart& start, const Point& to);
    /// The end whose numbers are those that are held, exactly, and otherwise the pointer's.
    Point (*end)(const GestureStart& start, const Point& pointer, const Held& held);
    /// What a typed "10,20" is.
    enum class Points : std::uint8_t { Relative, Absolute, Refused };
    Points points;
    /// The pointer's place for a number that is a multiple of 15°; null: no number is an angle.
    Point (*toStep)(const GestureStart& start, const Point& pointer) = nullptr;
    bool equal = false; ///< one of the steered numbers decides the other
    /// Why these numbers are impossible, one sentence; null: all are possible.
    QString (*refusal)(const GestureStart& start, const Held& held) = nullptr;
};

/// For lines and moves; the end is that of the line, or of the point that is moved. A held angle
/// keeps the end on its ray. Centre: the gesture begins in the middle of the line.
const GestureMeasure& lengthAndAngle(Anchor anchor = Anchor::Opposite);
/// For shapes dragged from corner to corner. A positive width or height goes to the pointer's side,
/// a negative one to the left or up. Square: both are the held one, otherwise the longer one.
/// Centre: the gesture begins in the middle of the shape.
const GestureMeasure& widthAndHeight(Proportion proportion = Proportion::Free,
                                     Anchor anchor = Anchor::Opposite);
/// The same for a rectangle, with the radius of its corners.
const GestureMeasure& widthHeightAndRadius(Proportion proportion, Anchor anchor);
/// For shapes drawn from their centre: the distance and the angle of the pointer. Polygon: and the
/// number of corners. Star: and the radius of the inner corners as a share of that of the outer.
const GestureMeasure& radiusAndAngle();
const GestureMeasure& polygonMeasure();
const GestureMeasure& starMeasure();
/// For a side of a rectangle that is dragged; `axis` 0: the width, 1: the height.
const GestureMeasure& sideLength(int axis, Anchor anchor);
/// For a first point, measured from the origin of coordinates.
const GestureMeasure& position();

/// The pointer's place, turned about where the gesture begins.
Point turnedPointer(const GestureStart& start, double degrees);

/// The number of the first length or factor that is 0, so that nothing would remain.
std::optional<std::size_t> firstZero(const GestureMeasure& measure, const GestureStart& start,
                                     const Point& to);

} // namespace app
