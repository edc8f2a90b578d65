// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/last_drawn.h"
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

namespace ui {
namespace {

/// Draws a line from press to release, or lines from click to click: each begins where the last one
/// ends, until Enter, Esc or a double click.
class LineTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        if (from_ && !pressed_)
            return next(pointer.position, bench);
        last_.forget();
        pressed_ = pointer.screen;
        begin(pointer.position, bench);
    }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        if (from_)
            show(pointer.position, bench);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        const auto pressed = std::exchange(pressed_, std::nullopt);
        if (pressed && from_ && dragged(*pressed, pointer))
            finish(pointer.position, bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override
    {
        starts_.empty() ? press(pointer, bench) : cancel(bench);
    }
    bool key(QKeyEvent& event, Workbench& bench) override
    {
        const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
        if (!from_ || !enter)
            return false;
        cancel(bench);
        return true;
    }
    void cancel(Workbench& bench) override
    {
        from_.reset();
        pressed_.reset();
        starts_.clear();
        last_.restore(bench);
        bench.session.setPreview({});
    }
    bool busy() const override { return from_.has_value(); }
    bool draws() const override { return true; }

    bool canTakeBack() const override { return from_ && !starts_.empty(); }
    void takeBack(Workbench& bench) override
    {
        bench.session.history.undo();
        begin(std::exchange(starts_.back(), {}), bench);
        starts_.pop_back();
    }
    QString stepText() const override
    {
        return QCoreApplication::translate("Commands", "Draw line");
    }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        if (!from_)
            return gaugeOfStart(bench);
        app::Gauge gauge = gaugeFrom(*from_, app::lengthAndAngle(), bench);
        gauge.aim = last_.end();
        return gauge;
    }
    void accept(const app::Point& point, Workbench& bench) override
    {
        if (!from_)
            begin(point, bench);
        else if (last_.isOpen())
            finish(point, bench);
        else
            next(point, bench);
    }
    void reopen(Workbench& bench) override
    {
        if (const auto gesture = last_.reopen(bench))
            begin(gesture->from, bench);
    }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (from_)
            preview(painter, bench, path(to_));
    }

private:
    void begin(const app::Point& from, Workbench& bench)
    {
        from_ = from;
        show(last_.end().value_or(from), bench);
    }
    void show(const app::Point& to, Workbench& bench)
    {
        to_ = to;
        bench.session.setPreview({.line = clipping::Segment{*from_, to}});
    }
    void add(const app::Point& to, Workbench& bench)
    {
        draw(bench, {path(to)}, QCoreApplication::translate("Commands", "Draw line"));
    }
    /// A single line.
    void finish(const app::Point& to, Workbench& bench)
    {
        const app::Point from = *from_;
        if (to == from)
            return cancel(bench);
        last_.discard();
        add(to, bench);
        cancel(bench);
        last_.remember({from, to}, bench);
    }
    /// A line of a chain.
    void next(const app::Point& to, Workbench& bench)
    {
        if (to == *from_)
            return;
        add(to, bench);
        starts_.push_back(*from_);
        begin(to, bench);
    }
    app::Subpath path(const app::Point& to) const
    {
        return {*from_, {app::PathSegment{to}}, false};
    }

    std::optional<app::Point> from_;
    std::optional<app::Point> pressed_; ///< on the screen; empty: the button is up
    std::vector<app::Point> starts_;    ///< of the chain's lines
    app::Point to_{};
    LastDrawn last_;
};

} // namespace

std::unique_ptr<Tool> makeLineTool() { return std::make_unique<LineTool>(); }

} // namespace ui
