// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QColor>
#include <QPainterPath>

#include <span>

class QPainter;

namespace app {

/// What is painted on: each has its own colours.
enum class Ground : std::uint8_t { Light, Dark };

/// How an algorithm is told from others.
struct AlgorithmMark {
    QColor light, dark; ///< on either ground
    QPainterPath path;  ///< around (0, 0) in the circle of radius 1
};
/// The mark of an algorithm of a catalogue. A row without a mark of its own has one that no other
/// row of that catalogue has. An algorithm that is not in the catalogue has a disc in the colour of
/// the text.
AlgorithmMark markOf(const clipping::Algorithm& algorithm,
                     std::span<const clipping::Algorithm> catalogue = clipping::algorithms());

/// The colour of an algorithm: told apart by all kinds of sight, together with its marker.
QColor algorithmColour(const clipping::Algorithm& algorithm, Ground ground);

/// Its marker, around (0, 0) in the circle of radius 1.
QPainterPath markerPath(const clipping::Algorithm& algorithm);

/// Paints the marker into a square, filled for the corrected form, hollow for the published one.
void paintMarker(QPainter& painter, const QRectF& box, const Variant& variant, Ground ground);

/// The same of any path within that circle, in any colour.
void paintMarker(QPainter& painter, const QRectF& box, const QPainterPath& path,
                 clipping::Form form, const QColor& colour);

} // namespace app
