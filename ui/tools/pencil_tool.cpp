// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/simplify.h"
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

namespace ui {
namespace {

constexpr double roughness = 0.7; // maximum deviation from the pointer's path, in pixels

/// Draws a freehand line, simplified to as few points as look the same.
class PencilTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench&) override { points_ = {pointer.raw}; }
    void move(const Pointer& pointer, Workbench&) override
    {
        if (!points_.empty() && pointer.raw != points_.back())
            points_.push_back(pointer.raw);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        move(pointer, bench);
        const auto few = app::simplified(points_, bench.inDrawing(roughness));
        if (few.size() >= 2)
            draw(bench, {pathOf(few)}, QCoreApplication::translate("Commands", "Draw freehand"));
        points_.clear();
    }
    void cancel(Workbench&) override { points_.clear(); }
    bool busy() const override { return !points_.empty(); }
    bool draws() const override { return true; }
    std::optional<app::Subpath> pendingPath() const override
    {
        return points_.size() >= 2 ? std::optional(pathOf(points_)) : std::nullopt;
    }
    std::size_t pendingPoints() const override { return points_.size(); }
    app::SnapTo snapsTo() const override { return app::SnapTo::Nothing; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (points_.size() >= 2)
            preview(painter, bench, pathOf(points_));
    }

private:
    static app::Subpath pathOf(const std::vector<app::Point>& points)
    {
        app::Subpath path{points.front(), {}, false};
        for (std::size_t i = 1; i < points.size(); ++i)
            path.segments.push_back({points[i]});
        return path;
    }

    std::vector<app::Point> points_;
};

} // namespace

std::unique_ptr<Tool> makePencilTool() { return std::make_unique<PencilTool>(); }

} // namespace ui
