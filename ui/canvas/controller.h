// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"
#include "app/view/picture.h"
#include "app/view/snap.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/letters.h"
#include "ui/canvas/navigation.h"
#include "ui/tools/tool.h"

#include <QTimer>

#include <functional>

namespace ui {

/// When two frames' keys are equal, so are their pictures.
struct FrameKey {
    std::uint64_t revision = 0; ///< of the drawing, its display, the selection and the look
    app::View view;
    app::ClipRegion region{};
    std::optional<app::Variant> choice{}; ///< nothing only in the key of no frame
    std::uint64_t found = 0;              ///< of what differs
    friend bool operator==(const FrameKey&, const FrameKey&) = default;
};

/// What one of the surfaces that share a controller shows.
struct Pane {
    app::Variant choice;
    bool active = true;                        ///< has the clip window's handles and label
    int among = 1;                             ///< so many panes are painted in one frame
    app::LiveDifferences* fromExact = nullptr; ///< what differs is marked; null: nothing
    std::uint64_t revision = 0;                ///< of what was found there
};

/// What all surfaces have in common: the view, the tool, what the pointer and keys do, and what a
/// frame shows. Panes side by side have one controller, hence one view and one gesture. It knows no
/// widget.
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

    /// An event of a widget that shows the drawing; whether it was used up.
    bool handle(QEvent& event);
    /// Where the document is wanted, or the view is about to change under the pointer: keeps what
    /// can be kept of the gesture.
    void endGesture();
    std::optional<app::ObjectInHand> objectInHand() const; ///< what endGesture() would keep now

    /// One step back or forth: a corner of the polyline in hand, else of the history. In the middle
    /// of a drag, undo() drops the drag and redo() does nothing.
    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    QString undoText() const; ///< what that step is called
    QString redoText() const;

    /// The clip window as it is now, in the middle of a gesture too.
    std::optional<clipping::Window> clipWindow() const { return session_.clipWindow(); }
    /// The same; without one, the page.
    clipping::Window window() const { return session_.window(); }
    /// Boxes that labels should not hide, in logical pixels.
    const std::vector<QRectF>& letters() const { return letters_.in(view()); }
    QColor pageColour() const;
    double ghostOpacity() const; ///< of the layer of ghosts
    FrameKey key(const Pane& pane) const
    {
        return {revision_, view(), session_.region(), pane.choice, pane.revision};
    }
    /// All lines, timed. Panes take turns: the frame is valid until the next one is clipped.
    app::SceneFrame clip(const Pane& pane) const
    {
        return session_.scene.clip(session_.region(), pane.choice);
    }
    app::Picture picture(const app::SceneFrame& frame, const Pane& pane, double pixelRatio) const;
    /// What a pane leaves that is not what exact leaves; null: not known, or not asked for.
    const app::Differences* differing(const Pane& pane) const;

signals:
    void changed(); ///< paint again
    void viewChanged();
    void pointerMoved(std::optional<app::Point> position);
    void toolChanged();
    void hintChanged();
    /// What undo() and redo() do, or what is in hand; of a line that follows the hand every 100 ms.
    void stepsChanged();

private:
    void addErrors(app::PictureOptions& options) const;
    void outdate();
    void renew();
    void followDisplay();
    bool mayDraw() const;
    void pointerEvent(QMouseEvent& event);
    void press(QMouseEvent& event);
    bool pressOffer(const QMouseEvent& event);
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
    /// What stepsChanged() tells of, as far as a tool changes it.
    struct Steps {
        bool undo = false, redo = false, takeBack = false;
        std::size_t points = 0;
        friend bool operator==(const Steps&, const Steps&) = default;
    };
    Steps steps() const;
    void tellSteps(const Steps& before);
    void withTool(const std::function<void()>& call); ///< notices what it changed

    app::Session& session_;
    Navigation navigation_;
    app::Picking picking_;
    mutable Letters letters_; ///< found when they are asked for
    app::Display shown_; ///< but for the algorithm, which is each pane's own
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
    bool onOffer_ = false; ///< the last click of the left button: it is no tool's
    QTimer growing_; ///< runs while what is in hand has points that stepsChanged() has not told
    std::uint64_t revision_ = 1;
};

} // namespace ui
