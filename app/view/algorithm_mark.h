// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QColor>
#include <QPainterPath>

#include <span>

class QPainter;

namespace app {

/// The kind of background; each has its own colours.
enum class Ground : std::uint8_t { Light, Dark };

/// The colours and the marker that distinguish an algorithm.
struct AlgorithmMark {
    QColor light, dark; ///< for each background
    QPainterPath path;  ///< the marker, centred on (0, 0), inside the circle of radius 1
};
/// The mark of an algorithm in a catalogue. A row without a mark of its own gets one that is unique
/// in the catalogue. An algorithm outside the catalogue gets a disc in the text colour.
AlgorithmMark markOf(const clipping::Algorithm& algorithm,
                     std::span<const clipping::Algorithm> catalogue = clipping::algorithms());

/// The colour of an algorithm. Together with the marker it is distinguishable with any colour
/// vision.
QColor algorithmColour(const clipping::Algorithm& algorithm, Ground ground);

/// The marker of an algorithm, centred on (0, 0), inside the circle of radius 1.
QPainterPath markerPath(const clipping::Algorithm& algorithm);

/// Paints the marker into a square: filled for the corrected form, hollow for the published form.
void paintMarker(QPainter& painter, const QRectF& box, const Variant& variant, Ground ground);

/// Paints any path within the circle of radius 1 in the same way, in any colour.
void paintMarker(QPainter& painter, const QRectF& box, const QPainterPath& path,
                 clipping::Form form, const QColor& colour);

} // namespace app
