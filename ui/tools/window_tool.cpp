// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_window.h"
#include "ui/tools/window_gesture.h"

namespace ui {
namespace {

/// Edits the clip window: a drag outside it draws another one, a drag inside moves it, a handle
/// resizes it.
class WindowTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        hoveredHandle_ = handleUnder(pointer, bench);
        if (hoveredHandle_)
            gesture_.start(*hoveredHandle_, pointer, bench.session.window());
        else
            gesture_.startNew(pointer);
    }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        if (gesture_.going())
            gesture_.proceed(pointer, bench);
        else
            hoveredHandle_ = handleUnder(pointer, bench);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        gesture_.finish(pointer, bench);
    }
    void leave(Workbench&) override
    {
        if (!gesture_.going())
            hoveredHandle_.reset();
    }
    bool key(QKeyEvent& event, Workbench& bench) override;
    void cancel(Workbench& bench) override { gesture_.cancel(bench); }
    bool busy() const override { return gesture_.going(); }

    QCursor cursor(const Workbench&) const override
    {
        return hoveredHandle_ ? cursorOf(*hoveredHandle_) : Qt::CrossCursor;
    }
    app::SnapTo snapsTo() const override { return app::SnapTo::All.without("window"); }
    const app::MovedSnap* snapped() const override { return gesture_.snapped(); }
    bool showsHandles() const override { return true; }
    std::optional<app::Handle> hoveredHandle() const override { return hoveredHandle_; }

private:
    static std::optional<app::Handle> handleUnder(const Pointer& pointer, const Workbench& bench)
    {
        const auto window = bench.session.clipWindow();
        if (!window)
            return std::nullopt;
        if (const auto handle = app::handleAt(pointer.screen, *window, bench.view))
            return handle;
        const app::Point p = pointer.raw;
        const auto& [min, max] = *window;
        const bool inside = p.x >= min.x && p.y >= min.y && p.x <= max.x && p.y <= max.y;
        return inside ? std::optional(app::Handle{}) : std::nullopt;
    }

    WindowGesture gesture_;
    std::optional<app::Handle> hoveredHandle_;
};

// With this tool the arrow keys move the window, even if objects are selected.
bool WindowTool::key(QKeyEvent& event, Workbench& bench)
{
    const int key = event.key();
    if (event.modifiers() & (Qt::AltModifier | Qt::ControlModifier) || gesture_.going())
        return false;
    app::Point by(int(key == Qt::Key_Right) - int(key == Qt::Key_Left),
                  int(key == Qt::Key_Down) - int(key == Qt::Key_Up));
    if (by == app::Point(0))
        return false;
    by *= nudge(bench, event.modifiers());
    const auto w = bench.session.clipWindow();
    if (!w)
        return false;
    bench.session.history.push(new app::SetWindow(
        bench.session.document, {w->min + by, w->max + by}, app::Merging::WithLast));
    return true;
}

} // namespace

std::unique_ptr<Tool> makeWindowTool() { return std::make_unique<WindowTool>(); }

} // namespace ui
