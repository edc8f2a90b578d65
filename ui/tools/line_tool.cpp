// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

namespace ui {
namespace {

/// A line from press to release.
class LineTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench&) override
    {
        from_ = pointer;
        to_ = pointer.position;
    }
    void move(const Pointer& pointer, Workbench&) override
    {
        if (from_)
            to_ = endAt(pointer);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        if (from_ && dragged(from_->screen, pointer))
            draw(bench, {path(endAt(pointer))},
                 QCoreApplication::translate("Commands", "Draw line"));
        from_.reset();
    }
    void cancel(Workbench&) override { from_.reset(); }
    bool busy() const override { return from_.has_value(); }
    bool draws() const override { return true; }
    std::optional<clipping::Segment> lineInHand() const override
    {
        return from_ ? std::optional(clipping::Segment{from_->position, to_}) : std::nullopt;
    }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (from_)
            preview(painter, bench, path(to_));
    }

private:
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
