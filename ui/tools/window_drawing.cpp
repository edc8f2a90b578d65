// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/window_drawing.h"

#include "ui/look/text.h"
#include "ui/tools/centre_tool.h"
#include "ui/tools/node_chain.h"

namespace ui {
namespace {

/// A window from one point to another, by a drag.
class WindowOfTwoPoints final : public TwoPointGesture, public TakesKeys {
public:
    explicit WindowOfTwoPoints(const app::WindowKind& kind) : kind_(kind) {}

    // A click beside the windows draws nothing: this is the tool of the first start.
    void release(const Pointer& pointer, Workbench& bench) override
    {
        TwoPointGesture::release(pointer, bench);
        if (busy())
            cancel(bench);
    }
    void cancel(Workbench& bench) override
    {
        const bool restores = corrects();
        TwoPointGesture::cancel(bench);
        window_.drop(bench);
        if (restores)
            window_.choose(bench);
    }
    bool key(QKeyEvent& event, Workbench&) override
    {
        return gesture_ && kind_.usual && changesCorners(event, gesture_->numbers);
    }

protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const override
    {
        return kind_.measure(proportionOf(modifiers), anchorOf(modifiers));
    }
    app::Numbers usual() const override { return kind_.usual ? kind_.usual() : app::Numbers{}; }
    std::string_view keeps() const override { return kind_.usual ? kind_.key : ""; }
    void follow(const Gesture&, Workbench& bench) override
    {
        isEmpty() ? window_.drop(bench) : window_.show(shape(), bench);
    }
    void make(Workbench& bench) override { window_.keep(shape(), bench); }

private:
    app::WindowShape shape() const
    {
        const auto& [from, to, modifiers, numbers] = *gesture_;
        return kind_.drawn({from, to, numbers, proportionOf(modifiers), anchorOf(modifiers)});
    }

    const app::WindowKind& kind_;
    DrawnWindow window_;
};

/// A window corner by corner. A click on the first corner or Enter closes it; Esc keeps it, too.
class WindowOfCorners final : public ChainTool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        ChainTool::press(pointer, bench);
        follow(bench);
    }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        ChainTool::move(pointer, bench);
        follow(bench);
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        ChainTool::accept(end, bench);
        follow(bench);
    }
    void takeBack(Workbench& bench) override
    {
        ChainTool::takeBack(bench);
        follow(bench);
    }
    void end(Workbench& bench) override { finish(bench, true); }
    void cancel(Workbench& bench) override
    {
        ChainTool::cancel(bench);
        window_.drop(bench);
    }
    QString stepText() const override { return Text::tr("Place corner"); }

protected:
    bool closes(const Workbench&) const override { return true; }
    void paintPath(QPainter& painter, const Workbench& bench,
                   const app::Subpath& path) const override
    {
        if (path.segments.size() > 1)
            return; // the canvas shows the window
        painter.setPen(QPen(bench.look.accent, 1));
        for (const app::PathSegment& side : path.segments)
            painter.drawLine(bench.onScreen(path.start), bench.onScreen(side.to));
    }
    void keep(app::Subpath path, Workbench& bench) override
    {
        if (const auto shape = shapeOf(path))
            return window_.keep(*shape, bench);
        emit bench.session.refused(
            Text::tr("No clip window was drawn: its corners lie on one line. Place at least three "
                     "corners that enclose an area."));
    }

private:
    static std::optional<app::WindowShape> shapeOf(const app::Subpath& path)
    {
        const app::Path whole({&path, 1});
        return path.segments.size() >= 2 && whole.hasArea()
                   ? std::optional<app::WindowShape>(app::PathShape{whole})
                   : std::nullopt;
    }
    void follow(Workbench& bench)
    {
        if (nodes_.empty())
            return;
        app::Subpath path = pathOf(nodes_, true);
        if (to_ && *to_ != nodes_.back().at)
            path.segments.push_back({*to_});
        if (const auto shape = shapeOf(path))
            window_.show(*shape, bench);
        else
            window_.drop(bench);
    }

    DrawnWindow window_;
};

} // namespace

bool canCorrect(const Tool& drawing, const Workbench& bench)
{
    const auto* gesture = dynamic_cast<const WindowOfTwoPoints*>(&drawing);
    return gesture && gesture->canCorrect(bench);
}

std::unique_ptr<Tool> makeWindowDrawing(const app::WindowKind& kind)
{
    if (kind.drawn)
        return std::make_unique<WindowOfTwoPoints>(kind);
    return std::make_unique<WindowOfCorners>();
}

} // namespace ui
