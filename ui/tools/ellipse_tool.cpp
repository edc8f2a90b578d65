// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/corner_tool.h"

#include <QCoreApplication>

namespace ui {
namespace {

constexpr double quarter =
    0.5522847498307936; // of the radius: a Bézier curve like a quarter circle

class EllipseTool final : public CornerTool {
protected:
    app::Subpath pathIn(const clipping::Window& r) const override
    {
        const app::Point radius = (r.max - r.min) * 0.5, centre = r.min + radius;
        const auto at = [&](double x, double y) { return centre + radius * app::Point(x, y); };
        const auto curve = [&](app::Point a,
                               app::Point b) { // unit directions, a quarter turn apart
            const app::Point from = a + b * quarter, to = b + a * quarter;
            return app::PathSegment{at(b.x, b.y), at(from.x, from.y), at(to.x, to.y), true};
        };
        return {at(1, 0),
                {curve({1, 0}, {0, 1}), curve({0, 1}, {-1, 0}), curve({-1, 0}, {0, -1}),
                 curve({0, -1}, {1, 0})},
                true};
    }
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw ellipse");
    }
};

} // namespace

std::unique_ptr<Tool> makeEllipseTool() { return std::make_unique<EllipseTool>(); }

} // namespace ui
