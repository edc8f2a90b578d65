// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <span>
#include <vector>

// The places of labels and hatching on a screen: pixels, y down.

namespace app {

/// Finds places for labels that cover neither each other nor existing content.
class LabelPlaces {
public:
    /// `taken` is never covered; `avoided` is covered only if there is no other place.
    LabelPlaces(const QRectF& room, std::vector<QRectF> taken, std::vector<QRectF> avoided = {})
        : room_(room), taken_(std::move(taken)), avoided_(std::move(avoided))
    {
    }
    /// The first of these rectangles that lies in the room, is free and covers nothing avoided;
    /// otherwise the first free one. The result is then taken.
    std::optional<QRectF> first(std::span<const QRectF> wanted);
    /// Marks a rectangle as taken.
    void take(const QRectF& rectangle) { taken_.push_back(rectangle); }

private:
    QRectF room_;
    std::vector<QRectF> taken_, avoided_;
};

/// The bounding boxes of lines that are short on the screen, such as letters of a drawing, so that
/// labels can avoid them. Empty if there are thousands, which no label could avoid.
std::vector<QRectF> boxesOfShortLines(std::span<const QLineF> lines, const QRectF& room);

/// Places beside a point, the best first: right, left, above and below.
std::vector<QRectF> placesBeside(const QPointF& point, const QSizeF& size, double gap);
/// Places inside a convex area: its middle, and places between the middle and its corners. Empty if
/// the area is too small.
std::vector<QRectF> placesInside(const QPolygonF& convex, const QSizeF& size);
/// Places near each end of a line, on both sides of the line.
std::vector<QRectF> placesAlong(const QLineF& line, const QSizeF& size, double gap);

/// Lines that hatch a convex area, rising to the right, aligned between areas; empty for an
/// unbounded area.
std::vector<QLineF> hatching(const QPolygonF& convex, double spacing);

} // namespace app
