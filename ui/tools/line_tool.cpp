// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

namespace ui {
namespace {

/// Draws a line from press to release.
class LineTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        from_ = pointer;
        show(pointer.position, bench);
    }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        if (from_)
            show(endAt(pointer), bench);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        if (from_ && dragged(from_->screen, pointer))
            draw(bench, {path(endAt(pointer))},
                 QCoreApplication::translate("Commands", "Draw line"));
        cancel(bench);
    }
    void cancel(Workbench& bench) override
    {
        from_.reset();
        bench.session.setPreview({});
    }
    bool busy() const override { return from_.has_value(); }
    bool draws() const override { return true; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (from_)
            preview(painter, bench, path(to_));
    }

private:
    void show(const app::Point& to, Workbench& bench)
    {
        to_ = to;
        bench.session.setPreview({.line = clipping::Segment{from_->position, to}});
    }
    app::Point endAt(const Pointer& pointer) const
    {
        return pointer.modifiers & Qt::ShiftModifier ? turned(from_->position, pointer.position)
                                                     : pointer.position;
    }
    app::Subpath path(const app::Point& to) const
    {
        return {from_->position, {app::PathSegment{to}}, false};
    }

    std::optional<Pointer> from_;
    app::Point to_{};
};

} // namespace

std::unique_ptr<Tool> makeLineTool() { return std::make_unique<LineTool>(); }

} // namespace ui
