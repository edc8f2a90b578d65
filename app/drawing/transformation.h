// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/drawing/readout.h"

#include <span>
#include <string_view>

// How a gesture moves, rotates, scales or skews the selected objects about a pivot.

namespace app {

/// The axis along which a transformation acts.
enum class Along : std::uint8_t { Both, X, Y };

/// One kind of transformation. A gesture of it begins with the pivot at `GestureStart::from`.
struct Transformation {
    std::string_view key; ///< "rotate"
    QChar letter;         ///< the key that begins it
    QString name;         ///< "Rotate": in menus
    QString undoText;     ///< "Rotate selection"
    QString needs;        ///< the sentence if nothing is selected
    const GestureMeasure& (*measure)(Along axis);
    /// What the gesture does if it is done `times` times, or a part of it.
    AffineMap (*map)(const GestureStart& start, const GestureEnd& end, Along axis, double times);
    /// The pivot follows the gesture. Otherwise it stays, and the pointer's first place counts.
    bool movesPivot = false;
};

// THE CATALOGUE. To add a kind: write its measure and map, and add its row.
std::span<const Transformation> transformations();
const Transformation* findTransformation(std::string_view key);

constexpr double mostSkew = 89; ///< degrees

/// Length and angle of the way; along an axis, only the way on it.
const GestureMeasure& moveMeasure(Along axis);
/// The angle about the pivot from where the pointer was to where it is.
const GestureMeasure& rotationMeasure(Along axis);
/// The pointer's distance from the pivot, divided by that at the start; negative on the other side.
const GestureMeasure& scalingMeasure(Along axis);
/// The angle by which the lines across the axis lean, below 90°.
const GestureMeasure& skewMeasure(Along axis);

} // namespace app
