// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/pattern.h"

#include "clipping/algorithm.h"

#include <QPainter>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace app {
namespace {

/// Parallel lines through the plane, clipped to the area: their positions do not depend on the
/// area, so that the lines of adjacent areas continue each other.
std::vector<QLineF> hatch(const QRectF& area, double degrees, double distance)
{
    const double angle = degrees * std::numbers::pi / 180;
    const glm::dvec2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
    const clipping::Window window{{area.left(), area.top()}, {area.right(), area.bottom()}};
    const glm::dvec2 middle = (window.min + window.max) / 2.0;
    const double reach = std::hypot(area.width(), area.height()) / 2,
                 centre = glm::dot(middle, across);
    std::vector<QLineF> lines;
    for (double i = std::ceil((centre - reach) / distance); i * distance < centre + reach; ++i) {
        const glm::dvec2 at = middle + (i * distance - centre) * across;
        const auto line = clipping::exactAlgorithm().corrected.clip(
            {at - along * reach, at + along * reach}, window);
        if (line && line->a != line->b)
            lines.emplace_back(line->a.x, line->a.y, line->b.x, line->b.y);
    }
    return lines;
}

} // namespace

std::span<const Pattern> patterns()
{
    static const std::array all{Pattern{1, {}}, Pattern{0.22, {-45}}, Pattern{0.5, {}},
                                Pattern{0.16, {45, -45}, 5}, Pattern{0.08, {90}, 3}};
    return all;
}

void paintPattern(QPainter& painter, const QRectF& area, const Pattern& pattern,
                  const QColor& colour, double unit)
{
    if (area.isEmpty())
        return;
    QColor tint = colour;
    tint.setAlphaF(float(pattern.tint));
    painter.fillRect(area, tint);
    painter.setPen(QPen(colour, 1.2 * unit, Qt::SolidLine, Qt::FlatCap));
    for (const double angle : pattern.angles)
        for (const QLineF& line : hatch(area, angle, pattern.distance * unit))
            painter.drawLine(line);
}

} // namespace app
