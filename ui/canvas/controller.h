// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"
#include "app/view/snap.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/navigation.h"
#include "ui/tools/tool.h"

#include <functional>

namespace ui {

/// When two frames' keys are equal, so are their pictures.
struct FrameKey {
    std::uint64_t revision = 0; ///< of the drawing, its display, the selection and the look
    app::View view;
    clipping::Window window{};
    friend bool operator==(const FrameKey&, const FrameKey&) = default;
};

/// What both canvases have in common: the view, the tool, what the pointer and keys do, and what a
/// frame shows. It knows no widget.
class Controller : public QObject {
    Q_OBJECT

public:
    explicit Controller(app::Session& session, QObject* parent = nullptr);

    app::Session& session() const { return session_; }
    Navigation& navigation() { return navigation_; }
    const app::View& view() const { return navigation_.view(); }
    const Look& look() const { return look_; }
    void setLook(const Look& look);
    void setSnapping(app::SnapTo to) { snapTo_ = to; }

    void setTool(std::string_view key);
    const ToolInfo& toolInfo() const { return *toolInfo_; }
    const Tool& tool() const { return *tool_; }
    const Workbench& bench() const { return bench_; }
    QString hint() const;
    QCursor cursor() const;
    const std::optional<Pointer>& pointer() const { return pointer_; }
    const std::optional<app::Snap>& snapped() const { return snap_; }

    void fitDrawing();
    void fitSelection();
    void fitWindow();
    double zoom() const; ///< 1: 100 %, a millimetre on paper is 96 / 25.4 logical pixels
    void setZoom(double zoom);

    /// An event of the widget that shows the drawing; whether it was used up.
    bool handle(QEvent& event);

    /// The clip window as it is now, in the middle of a gesture too.
    clipping::Window window() const;
    QColor pageColour() const;
    FrameKey key() const { return {revision_, view(), window()}; }
    app::Frame clip() const; ///< all segments, timed
    app::Picture picture(const app::Frame& frame, double pixelRatio) const;

signals:
    void changed(); ///< paint again
    void viewChanged();
    void pointerMoved(std::optional<app::Point> position);
    void toolChanged();
    void hintChanged();

private:
    void outdate();
    bool mayDraw() const;
    void pointerEvent(QMouseEvent& event);
    void press(QMouseEvent& event);
    void move(QMouseEvent& event);
    void release(QMouseEvent& event);
    bool keyPress(QKeyEvent& event);
    bool keyRelease(QKeyEvent& event);
    bool navigationKey(const QKeyEvent& event);
    bool toolKey(const QKeyEvent& event);
    bool arrow(const QKeyEvent& event);
    bool escape();
    Pointer pointerAt(const QPointF& screen, Qt::MouseButtons buttons,
                      Qt::KeyboardModifiers modifiers);
    void withTool(const std::function<void()>& call); ///< notices what it changed

    app::Session& session_;
    Navigation navigation_;
    app::Picking picking_;
    Look look_;
    app::View toolView_; ///< what tools move; compared with the view after each call
    Workbench bench_;
    const ToolInfo* toolInfo_ = nullptr;
    std::unique_ptr<Tool> tool_;
    app::SnapTo snapTo_ = app::SnapTo::All;
    std::optional<Pointer> pointer_;
    std::optional<app::Snap> snap_;
    std::optional<QPointF> panningFrom_;
    bool space_ = false;
    std::uint64_t revision_ = 1;
};

} // namespace ui
