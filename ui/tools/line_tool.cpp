// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/two_points.h"

#include <QCoreApplication>

namespace ui {
namespace {

/// Draws a line by a drag, or lines from click to click: each begins where the last one ends, until
/// Enter, Esc or a double click.
class LineTool final : public TwoPointTool {
public:
    void doubleClick(const Pointer& pointer, Workbench& bench) override
    {
        starts_.empty() ? press(pointer, bench) : cancel(bench);
    }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
        if (!busy() || !enter)
            return false;
        cancel(bench);
        return true;
    }
    void cancel(Workbench& bench) override
    {
        TwoPointTool::cancel(bench);
        starts_.clear();
        bench.session.setPreview({});
    }

    bool canTakeBack() const override { return busy() && !starts_.empty(); }
    void takeBack(Workbench& bench) override
    {
        bench.session.history.undo();
        const app::Point start = starts_.back();
        starts_.pop_back();
        begin(start, bench);
    }
    QString stepText() const override { return undoText(); }

protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers) const override
    {
        return app::lengthAndAngle();
    }
    app::Subpath path(const Gesture& gesture) const override
    {
        return {gesture.from, {app::PathSegment{gesture.to}}, false};
    }
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw line");
    }
    void follow(const Gesture& gesture, Workbench& bench) override
    {
        bench.session.setPreview({.line = clipping::Segment{gesture.from, gesture.to}});
    }
    void finishByClick(Workbench& bench) override
    {
        if (isEmpty())
            return;
        add(bench);
        starts_.push_back(gesture_->from);
        begin(gesture_->to, bench);
    }

private:
    std::vector<app::Point> starts_; ///< of the chain's lines
};

} // namespace

std::unique_ptr<Tool> makeLineTool() { return std::make_unique<LineTool>(); }

} // namespace ui
