// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/centre_tool.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <cmath>

namespace ui {
namespace {

constexpr double pentagram = 0.381966011250105; // the inner radius where the sides continue

/// Draws a star; the fourth number is its inner radius as a share of the outer one.
class StarTool final : public CentreTool {
protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers) const override
    {
        return app::starMeasure();
    }
    app::Numbers usual() const override { return {0, 0, 5, pentagram}; }
    std::string_view keeps() const override { return "star"; }
    app::StarRecipe starOf(const Gesture& gesture) const override
    {
        const app::Point way = gesture.to - gesture.from;
        const double radius = glm::length(way);
        return {gesture.from, radius, radius * gesture.numbers[3], std::atan2(way.y, way.x),
                cornersOf(gesture)};
    }
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw star");
    }
};

} // namespace

std::unique_ptr<Tool> makeStarTool() { return std::make_unique<StarTool>(); }

} // namespace ui
