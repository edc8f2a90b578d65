// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QRectF>

#include <optional>
#include <span>
#include <vector>

// The places of a figure's labels, chosen one after the other, the most important first.

namespace app {

/// What a label must not cover, and what it should not cover if possible.
struct LabelObstacles {
    QRectF inside;               ///< labels stay within
    std::vector<QRectF> boxes;   ///< marks and labels that have their places already
    std::vector<QLineF> lines;   ///< never covered
    std::vector<QLineF> avoided; ///< covered only if there is no other place
};

/// Whether a box lies on one of the lines.
bool covers(const QRectF& box, std::span<const QLineF> lines);

/// The best of the places, with a preference for the first ones; empty if all are taken.
std::optional<QRectF> freePlace(std::span<const QRectF> places, const LabelObstacles& obstacles);

/// Places for a label of this size around a mark of that radius, nearest first.
std::vector<QRectF> placesAround(const QPointF& mark, double radius, const QSizeF& label);

/// Places all over an area, the nearest to a point first.
std::vector<QRectF> placesWithin(const QRectF& area, const QPointF& near, const QSizeF& label);

} // namespace app
