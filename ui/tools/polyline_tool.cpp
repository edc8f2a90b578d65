// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

namespace ui {
namespace {

/// A corner at every click. A click on the first corner closes it.
class PolylineTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        const app::Point next = placed(pointer);
        if (corners_.size() >= 3 && glm::distance(next, corners_.front()) <= bench.inDrawing(reach))
            finish(bench, true);
        else if (corners_.empty() || next != corners_.back())
            corners_.push_back(next);
        to_ = next;
    }
    void move(const Pointer& pointer, Workbench&) override { to_ = placed(pointer); }
    void doubleClick(const Pointer&, Workbench& bench) override { finish(bench, false); }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        if (corners_.empty())
            return false;
        if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
            finish(bench, false);
        else if (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete)
            corners_.pop_back();
        else
            return false;
        return true;
    }
    void cancel(Workbench&) override { corners_.clear(); }
    bool busy() const override { return !corners_.empty(); }
    bool draws() const override { return true; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (corners_.empty())
            return;
        app::Path path = pathOf(false);
        path.stretches.push_back({to_});
        preview(painter, bench, path);
        painter.setPen(QPen(bench.look.selection, 1.5));
        painter.setBrush(bench.look.paper);
        for (const app::Point& corner : corners_)
            painter.drawEllipse(bench.onScreen(corner), 3, 3);
    }

private:
    app::Point placed(const Pointer& pointer) const
    {
        const bool straight = pointer.modifiers & Qt::ShiftModifier && !corners_.empty();
        return straight ? turned(corners_.back(), pointer.position) : pointer.position;
    }
    app::Path pathOf(bool closed) const
    {
        app::Path path{corners_.front(), {}, closed};
        for (std::size_t i = 1; i < corners_.size(); ++i)
            path.stretches.push_back({corners_[i]});
        return path;
    }
    void finish(Workbench& bench, bool closed)
    {
        if (corners_.size() >= 2)
            draw(bench, {pathOf(closed)}, QCoreApplication::translate("Commands", "Draw polyline"));
        corners_.clear();
    }

    std::vector<app::Point> corners_;
    app::Point to_{};
};

} // namespace

std::unique_ptr<Tool> makePolylineTool() { return std::make_unique<PolylineTool>(); }

} // namespace ui
