// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <span>
#include <vector>

// Where labels and hatching go on a screen: pixels, y down.

namespace app {

/// Finds places for labels that hide neither each other nor what is there already.
class LabelPlaces {
public:
    /// What is `taken` is never hidden, what is `avoided` only where there is no other place.
    LabelPlaces(const QRectF& room, std::vector<QRectF> taken, std::vector<QRectF> avoided = {})
        : room_(room), taken_(std::move(taken)), avoided_(std::move(avoided))
    {
    }
    /// The first of these rectangles that lies in the room, is free and hides nothing that is
    /// avoided; else the first that is free. It is taken then.
    std::optional<QRectF> first(std::span<const QRectF> wanted);
    /// Something that is there in any case.
    void take(const QRectF& rectangle) { taken_.push_back(rectangle); }

private:
    QRectF room_;
    std::vector<QRectF> taken_, avoided_;
};

/// The boxes of the lines that are short on the screen, as letters of a drawing are, so that labels
/// can avoid them. None if there are thousands: no label could.
std::vector<QRectF> boxesOfShortLines(std::span<const QLineF> lines, const QRectF& room);

/// Places beside a point, the best first: right, left, and above or below.
std::vector<QRectF> placesBeside(const QPointF& point, const QSizeF& size, double gap);
/// Places inside a convex area: its middle, and between that and its corners. None: it is too
/// small.
std::vector<QRectF> placesInside(const QPolygonF& convex, const QSizeF& size);
/// Places at either end of a line, on both sides of it, a little way in.
std::vector<QRectF> placesAlong(const QLineF& line, const QSizeF& size, double gap);

/// Lines that hatch a convex area, rising to the right, at the same places for every area; none in
/// an area without bounds.
std::vector<QLineF> hatching(const QPolygonF& convex, double spacing);

} // namespace app
