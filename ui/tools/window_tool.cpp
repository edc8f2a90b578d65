// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"
#include "app/view/area_at.h"
#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/window_drawing.h"
#include "ui/tools/window_gesture.h"

namespace ui {
namespace {

/// Draws and edits clip windows: a drag inside a window chooses and moves it, a handle of the
/// chosen one resizes or rotates it, anything else draws a window. With Alt it may begin inside
/// another.
class WindowTool final : public Tool,
                         public TakesKeys,
                         public HasSteps,
                         public TypesNumbers,
                         public Snaps,
                         public Hovers {
public:
    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench& bench) override
    {
        if (drawing_)
            drawing_->move(pointer, bench);
        else if (gesture_.going())
            gesture_.proceed(pointer, bench);
        else
            hoveredHandle_ = handleUnder(pointer, bench);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        if (drawing_)
            drawing_->release(pointer, bench);
        else
            gesture_.finish(pointer, bench);
        forgetDrawn(bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override
    {
        drawing_ ? drawing_->doubleClick(pointer, bench) : press(pointer, bench);
        forgetDrawn(bench);
    }
    void leave(Workbench& bench) override
    {
        if (drawing_)
            drawing_->leave(bench);
        else if (!gesture_.going())
            hoveredHandle_.reset();
    }
    bool key(QKeyEvent& event, Workbench& bench) override;
    bool wants(const QKeyEvent& event, const Workbench& bench) const override
    {
        return drawing_ && drawing_->as<TakesKeys>().wants(event, bench);
    }
    void cancel(Workbench& bench) override
    {
        if (drawing_)
            drawing_->cancel(bench);
        forgetDrawn(bench);
        drawing_.reset();
        gesture_.cancel(bench);
    }
    void end(Workbench& bench) override
    {
        if (!drawing_)
            return cancel(bench);
        drawing_->end(bench);
        forgetDrawn(bench);
    }
    bool busy() const override { return drawing_ || gesture_.going(); }

    bool canTakeBack() const override { return drawing_ && drawing_->as<HasSteps>().canTakeBack(); }
    void takeBack(Workbench& bench) override
    {
        drawing_->as<HasSteps>().takeBack(bench);
        forgetDrawn(bench);
    }
    QString stepText() const override
    {
        return drawing_ ? drawing_->as<HasSteps>().stepText() : QString();
    }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        if (drawing_ || gesture_.going())
            return drawing_ ? numbers().gauge(bench) : gesture_.gauge(bench);
        return gaugeOfStart(bench); // of the next window
    }
    bool enterOpens(const Workbench& bench) const override
    {
        return corrigible(bench) || !bench.session.windowChosen();
    }
    void reopen(Workbench& bench) override
    {
        if (drawing_ || gesture_.going() || !corrigible(bench))
            return;
        drawing_ = std::move(drawn_);
        numbers().reopen(bench);
    }
    bool corrects() const override { return drawing_ && numbers().corrects(); }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        if (gesture_.going())
            return gesture_.accept(end, bench);
        if (!drawing_)
            begin(bench);
        numbers().accept(end, bench);
        forgetDrawn(bench);
    }

    QCursor cursor(const Workbench& bench) const override;
    void limit(app::SnapQuery& query) const override
    {
        if (hoveredHandle_ && !busy())
            query.to = query.to.without("window");
        if (gesture_.going())
            gesture_.limit(query);
    }
    const app::MovedSnap* snapped() const override { return gesture_.snapped(); }
    std::optional<app::Handle> hoveredHandle() const override { return hoveredHandle_; }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (drawing_)
            drawing_->paint(painter, bench);
    }

private:
    static constexpr double reach = 6; // pixels

    TypesNumbers& numbers() { return drawing_->as<TypesNumbers>(); }
    const TypesNumbers& numbers() const { return drawing_->as<TypesNumbers>(); }
    /// Whether a window that is drawn may begin inside another.
    static bool drawsInside(const Pointer& pointer) { return pointer.modifiers & Qt::AltModifier; }
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
        const bool inside = number && !drawsInside(pointer)
                            && app::isAt(session.windows().list[*number].shape, pointer.raw,
                                         bench.inDrawing(reach));
        return inside ? std::optional(app::Handle{}) : std::nullopt;
    }
    void begin(const Workbench& bench)
    {
        drawnWith_ = bench.session.nextWindow;
        drawing_ = makeWindowDrawing(app::windowKind(drawnWith_));
    }
    /// The next gesture may draw another shape; until then numbers change the one that was drawn.
    void forgetDrawn(const Workbench& bench)
    {
        if (!drawing_ || drawing_->busy())
            return;
        drawn_ = std::move(drawing_);
        drawnNumber_ = bench.session.windowNumber();
    }
    /// Whether numbers typed now change the window drawn last, which must be the chosen one. The
    /// shape of the next one must be the same.
    bool corrigible(const Workbench& bench) const
    {
        return drawn_ && bench.session.windowNumber() == drawnNumber_
               && bench.session.nextWindow == drawnWith_ && canCorrect(*drawn_, bench);
    }

    WindowGesture gesture_;
    std::unique_ptr<Tool> drawing_;          ///< null: no window is being drawn
    std::unique_ptr<Tool> drawn_;            ///< what has drawn the last window
    std::optional<std::size_t> drawnNumber_; ///< of the window that it has drawn
    std::string_view drawnWith_;             ///< the key of its shape
    std::optional<app::Handle> hoveredHandle_;
};

void WindowTool::press(const Pointer& pointer, Workbench& bench)
{
    if (corrects()) { // a press ends the correction
        drawing_->cancel(bench);
        forgetDrawn(bench);
    }
    if (!drawing_) {
        hoveredHandle_ = handleUnder(pointer, bench);
        if (hoveredHandle_)
            return gesture_.start(*hoveredHandle_, pointer, bench);
        if (const auto other = windowUnder(pointer, bench); other && !drawsInside(pointer)) {
            bench.session.chooseWindow(*other);
            return gesture_.start({}, pointer, bench);
        }
        begin(bench);
    }
    drawing_->press(pointer, bench);
    forgetDrawn(bench);
}

// With this tool the arrow keys move the window, even if objects are selected.
bool WindowTool::key(QKeyEvent& event, Workbench& bench)
{
    if (drawing_) {
        const bool used = drawing_->as<TakesKeys>().key(event, bench);
        forgetDrawn(bench);
        return used;
    }
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
    return hoveredHandle_ && !drawing_ && frame ? cursorOf(*hoveredHandle_, frame->angle)
                                                : Qt::CrossCursor;
}

QString WindowTool::hint(const Workbench& bench) const
{
    const QString now = drawing_ ? drawing_->hint(bench) : QString();
    if (!now.isEmpty())
        return now;
    const app::WindowKind& kind = app::windowKind(bench.session.nextWindow);
    return Text::tr((bench.session.windows().list.empty() ? kind.hint : kind.hintBeside).data());
}

} // namespace

std::unique_ptr<Tool> makeWindowTool() { return std::make_unique<WindowTool>(); }

} // namespace ui
