// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

namespace ui {
namespace {

/// Draws a polyline with a corner at every click. A click on the first corner closes it. Undo
/// removes the last corner.
class PolylineTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        const app::Point next = pointer.position;
        if (corners_.size() >= 3 && glm::distance(next, corners_.front()) <= bench.inDrawing(reach))
            finish(bench, true);
        else if (corners_.empty() || next != corners_.back())
            add(next);
        to_ = next;
    }
    void move(const Pointer& pointer, Workbench&) override { to_ = pointer.position; }
    void leave(Workbench&) override { to_.reset(); }
    void doubleClick(const Pointer&, Workbench& bench) override { end(bench); }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        if (corners_.empty())
            return false;
        if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
            end(bench);
        else if (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete)
            takeBack(bench);
        else
            return false;
        return true;
    }
    void cancel(Workbench&) override
    {
        corners_.clear();
        takenBack_.clear();
    }
    void end(Workbench& bench) override { finish(bench, false); }
    bool busy() const override { return !corners_.empty(); }
    bool draws() const override { return true; }

    bool canTakeBack() const override { return !corners_.empty(); }
    void takeBack(Workbench& bench) override
    {
        takenBack_.push_back(corners_.back());
        corners_.pop_back();
        stepsBefore_ = stepsDone(bench);
    }
    // When all corners are removed, Undo goes on with the history; those steps must be redone
    // before the corners return.
    bool canPutBack(const Workbench& bench) const override
    {
        return !takenBack_.empty() && (!corners_.empty() || stepsDone(bench) == stepsBefore_);
    }
    void putBack(Workbench&) override
    {
        corners_.push_back(takenBack_.back());
        takenBack_.pop_back();
    }
    QString stepText() const override
    {
        return QCoreApplication::translate("Commands", "Place corner");
    }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        return corners_.empty() ? gaugeOfStart(bench)
                                : gaugeFrom(corners_.back(), app::lengthAndAngle(), bench);
    }
    void accept(const app::GestureEnd& end, Workbench&) override
    {
        const app::Point point = end.point;
        if (corners_.empty() || point != corners_.back())
            add(point);
    }
    std::optional<app::Subpath> pendingPath() const override
    {
        return corners_.size() >= 2 ? std::optional(pathOf(false)) : std::nullopt;
    }
    std::size_t pendingPoints() const override { return corners_.size(); }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (corners_.empty())
            return;
        app::Subpath path = pathOf(false);
        if (to_)
            path.segments.push_back({*to_});
        preview(painter, bench, path);
        painter.setPen(QPen(bench.look.selection, 1.5));
        painter.setBrush(bench.look.paper);
        for (const app::Point& corner : corners_)
            painter.drawEllipse(bench.onScreen(corner), 3, 3);
    }

private:
    static int stepsDone(const Workbench& bench)
    {
        return bench.session.history.forgotten() + bench.session.history.index();
    }
    void add(const app::Point& corner)
    {
        corners_.push_back(corner);
        takenBack_.clear();
    }
    app::Subpath pathOf(bool closed) const
    {
        app::Subpath path{corners_.front(), {}, closed};
        for (std::size_t i = 1; i < corners_.size(); ++i)
            path.segments.push_back({corners_[i]});
        return path;
    }
    void finish(Workbench& bench, bool closed)
    {
        auto path = corners_.size() >= 2 ? std::optional(pathOf(closed)) : std::nullopt;
        cancel(bench);
        if (path)
            draw(bench, {std::move(*path)},
                 QCoreApplication::translate("Commands", "Draw polyline"));
    }

    std::vector<app::Point> corners_;
    std::vector<app::Point> takenBack_; ///< removed corners; the last one returns first
    int stepsBefore_ = 0;               ///< number of history steps done when a corner was removed
    std::optional<app::Point> to_;      ///< the corner that a click would add; empty: none
};

} // namespace

std::unique_ptr<Tool> makePolylineTool() { return std::make_unique<PolylineTool>(); }

} // namespace ui
