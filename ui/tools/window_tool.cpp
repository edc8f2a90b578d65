// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"
#include "app/view/window_at.h"
#include "ui/tools/window_gesture.h"

namespace ui {
namespace {

/// Edits clip windows: a drag outside them draws the window anew, a drag inside one chooses and
/// moves it, a handle of the chosen one resizes or rotates it.
class WindowTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        hoveredHandle_ = handleUnder(pointer, bench);
        if (hoveredHandle_)
            return gesture_.start(*hoveredHandle_, pointer, bench);
        if (const auto other = windowUnder(pointer, bench)) {
            bench.session.chooseWindow(*other);
            return gesture_.start({}, pointer, bench);
        }
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

    QCursor cursor(const Workbench& bench) const override;
    app::SnapTo snapsTo() const override { return app::SnapTo::All.without("window"); }
    const app::MovedSnap* snapped() const override { return gesture_.snapped(); }
    bool showsHandles() const override { return true; }
    std::optional<app::Handle> hoveredHandle() const override { return hoveredHandle_; }

private:
    static constexpr double reach = 6; // pixels

    static std::optional<std::size_t> windowUnder(const Pointer& pointer, const Workbench& bench)
    {
        return app::windowAt(bench.session.windows(), pointer.raw, bench.inDrawing(reach));
    }
    static std::optional<app::Handle> handleUnder(const Pointer& pointer, const Workbench& bench)
    {
        if (const auto handle = windowHandleAt(pointer.screen, bench))
            return handle;
        const auto& session = bench.session;
        const auto number = session.windowNumber();
        const bool inside = number
                            && app::isAt(session.windows().list[*number].shape, pointer.raw,
                                         bench.inDrawing(reach));
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
    if (!bench.session.windowNumber())
        return false;
    app::moveWindow(bench.session, by, app::Merging::WithLast);
    return true;
}

QCursor WindowTool::cursor(const Workbench& bench) const
{
    const auto& frame = bench.session.windowFrame();
    return hoveredHandle_ && frame ? cursorOf(*hoveredHandle_, frame->angle) : Qt::CrossCursor;
}

} // namespace

std::unique_ptr<Tool> makeWindowTool() { return std::make_unique<WindowTool>(); }

} // namespace ui
