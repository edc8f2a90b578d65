// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/centre_tool.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace ui {
namespace {

/// Draws a regular polygon. Alt: the pointer is at the middle of a side instead of a corner.
class PolygonTool final : public CentreTool {
protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers) const override
    {
        return app::polygonMeasure();
    }
    app::Numbers usual() const override { return {0, 0, 6}; }
    std::string_view keeps() const override { return "polygon"; }
    app::StarRecipe starOf(const Gesture& gesture) const override
    {
        const int corners = cornersOf(gesture);
        const app::Point way = gesture.to - gesture.from;
        const double radius = glm::length(way), angle = std::atan2(way.y, way.x);
        const double half = std::numbers::pi / corners;
        if (gesture.modifiers & Qt::AltModifier)
            return {gesture.from, radius / std::cos(half), 0, angle + half, corners};
        return {gesture.from, radius, 0, angle, corners};
    }
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw polygon");
    }
};

} // namespace

std::unique_ptr<Tool> makePolygonTool() { return std::make_unique<PolygonTool>(); }

} // namespace ui
