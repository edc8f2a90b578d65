// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"
#include "app/session/digits.h"
#include "app/view/drawing_pictures.h"
#include "app/view/snapping/snapper.h"
#include "ui/canvas/navigation.h"
#include "ui/canvas/text_boxes.h"
#include "ui/tools/guide_drag.h"
#include "ui/tools/tool_parts.h"

#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace app {
struct ObjectInHand;
}

namespace ui {

/// The content of one of the surfaces that share a controller.
struct Pane {
    app::Variant choice;
    bool active = true;                        ///< shows the clip window's handles and label
    int among = 1;                             ///< number of panes painted in one frame
    app::LiveDifferences* fromExact = nullptr; ///< differences from exact to mark; null: none
    std::uint64_t revision = 0;                ///< of the differences found in fromExact
    /// The windows at which its variant cannot clip (app/scene/left_alone.h), and what it clips at
    /// instead of all windows; empty: at all.
    std::vector<std::size_t> leftAlone{};
    std::optional<app::ClipRegion> region{};
};

/// The state that all surfaces share: the view, the tool, the handling of pointer and keys, and the
/// content of a frame. Panes side by side have one controller, hence one view and one gesture. It
/// does not depend on widgets.
class Controller : public QObject {
    Q_OBJECT

public:
    explicit Controller(app::Session& session, QObject* parent = nullptr);

    app::Session& session() const { return session_; }
    Navigation& navigation() { return navigation_; }
    const app::View& view() const { return navigation_.view(); }
    const Look& look() const { return look_; } ///< of the theme
    void setLook(const Look& look);
    const Look& paperLook() const { return paperLook_; } ///< of what lies on the drawing
    /// The kinds of places that the pointer snaps to, while snapping is on.
    app::SnapTo snapping() const { return snapTo_; }
    void setSnapping(app::SnapTo to);
    bool snaps() const { return snaps_; } ///< whether snapping is on
    void switchSnapping(bool on);

    void setTool(std::string_view key); ///< the current tool begins anew
    const ToolInfo& toolInfo() const { return *toolInfo_; }
    const Tool& tool() const { return *tool_; }
    const Workbench& bench() const { return bench_; }
    /// For the next object of a tool.
    void keepNumbers(std::string_view tool, const app::Numbers& numbers);
    QString hint() const;
    QCursor cursor() const;
    const std::optional<Pointer>& pointer() const { return pointer_; }
    const std::optional<app::Snap>& snapped() const { return snap_; }

    /// The numbers of the gesture; empty: the tool takes none now.
    const std::optional<app::Readout>& readout() const { return readout_; }
    bool typing() const { return typing_; } ///< a field of the readout is open
    bool showsReadout() const;
    /// What a digit does now. One that chooses the algorithm is a shortcut of the menu Clip, which
    /// digitsChoose() allows: the canvas takes the digits of a gesture before.
    app::DigitUse digitUse() const { return app::digitUse(digitPlace()); }
    bool digitsChoose() const; ///< outside gestures
    /// The box that shows the numbers, in logical pixels; empty: hidden.
    const QRectF& readoutPlace() const { return readoutPlace_; }
    void setReadoutPlace(const QRectF& place) { readoutPlace_ = place; }
    /// The controls of what is chosen (capsule.h), in logical pixels; empty: hidden.
    const QRectF& capsulePlace() const { return capsulePlace_; }
    void setCapsulePlace(const QRectF& place);
    /// Whether keys and the capsule are for the chosen clip window: with the tool Clip window, or
    /// if it was chosen after the selected objects.
    bool actsOnWindow() const;
    bool gestureGoes() const { return tool_->busy() || guide_.going() || panningFrom_; }
    /// Where the pointer would end the gesture, if nothing were typed.
    app::Point aim() const;
    void typeNumber(const QString& text); ///< replaces the text of the active field
    void lockNumber();                    ///< and goes on to the other field
    void releaseNumber(); ///< gives the active field back to the pointer, and stops typing
    /// Ends the gesture, or its current step, with these numbers. A direction alone is only locked.
    void acceptNumber();
    void stopTyping();

    void typeText(const app::TextRecipe& text); ///< of the tool's text
    void finishText();

    /// Moves, rotates, scales or skews the selection with the Select tool, from the keyboard.
    void transform(const app::Transformation& kind);

    /// Selects the object under a position, unless it is selected already; false: there is none.
    bool selectAt(const QPointF& screen);
    /// Chooses the clip window whose outline, handle or name is there; false: there is none, or an
    /// object comes first.
    bool chooseWindowAt(const QPointF& screen);

    /// A new guide follows the pointer: from a ruler, until it is dropped. `axis` as in app::Guide.
    void dragGuide(int axis);
    void moveGuide(const QPointF& screen, Qt::KeyboardModifiers modifiers);
    void dropGuide();
    const GuideDrag& guideDrag() const { return guide_; }

    void fitDrawing();
    void fitPage();
    void fitSelection();
    void fitWindow();
    double zoom() const; ///< 1 = 100 %: 1 mm on paper is 96 / 25.4 logical pixels
    void setZoom(double zoom);

    /// Handles an event of a widget that shows the drawing; true if the event was consumed.
    bool handle(QEvent& event);
    /// Ends the gesture and keeps what is complete. To be called before the document is read or the
    /// view changes under the pointer.
    void endGesture();
    std::optional<app::ObjectInHand> pendingObject() const; ///< what endGesture() would keep now

    /// Undo or redo one step: a corner of the polyline being drawn, else a step of the history.
    /// During a drag, undo() cancels the drag and redo() does nothing.
    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    void goToStep(int index);
    QString undoText() const; ///< the name of that step
    QString redoText() const;

    /// The current clip window, also during a gesture.
    std::optional<clipping::Window> clipWindow() const { return session_.clipWindow(); }
    /// The rectangle at which algorithms are compared.
    clipping::Window window() const { return session_.window(); }
    /// The handle that adds a clip window (window_offer.h), in logical pixels; empty if none is
    /// offered.
    QRectF offeredHandle() const;
    std::optional<std::size_t> nameAt(const QPointF& screen) const;
    /// The clip window whose name takes a click there.
    std::optional<std::size_t> tagAt(const QPointF& screen) const;
    /// Boxes that labels should not cover, in logical pixels.
    const std::vector<QRectF>& textBoxes() const { return textBoxes_.in(view()); }
    QColor pageColour() const;
    double ghostOpacity() const; ///< of the removed lines' layer, 0 to 1
    /// The frame that a pane shows now; `pixels` is the size of its image.
    app::FrameWish wish(const Pane& pane, double pixelRatio, const QSize& pixels) const;
    /// How long this turn of the event loop may still wait for pictures, which are painted on other
    /// threads. All panes share it.
    std::chrono::microseconds patience();
    /// The lines whose results differ between the pane's variant and `exact`; null: not known yet,
    /// or not asked for.
    std::shared_ptr<const app::Differences> differing(const Pane& pane) const;

signals:
    void changed(); ///< repaint
    void viewChanged();
    void pointerMoved(std::optional<app::Point> position);
    void readoutChanged();
    void typingBegan();
    void capsuleWanted(); ///< the keyboard should go to it
    void toolChanged();
    void hintChanged();
    /// The effect of undo() and redo(), or the object being drawn, has changed; for a freehand line
    /// emitted at most every 100 ms.
    void stepsChanged();

private:
    app::PictureOptions pictureOptions(double pixelRatio) const;
    void addDifferences(app::FrameWish& wish, const Pane& pane) const;
    void addErrors(app::FrameWish& wish) const;
    void inspectOnly();
    void followDocument();
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
    bool windowKey(const QKeyEvent& event);
    bool capsuleKey(const QKeyEvent& event);
    bool navigationKey(const QKeyEvent& event);
    bool toolKey(const QKeyEvent& event);
    bool transformKey(const QKeyEvent& event);
    bool takesNumbers() const;
    app::DigitPlace digitPlace() const;
    bool beginsTyping(const QKeyEvent& event) const;
    /// Whether the canvas has a use for the key before the shortcut of a command.
    bool takesKey(const QKeyEvent& event) const
    {
        return tool_->as<TakesKeys>().wants(event, bench_) || beginsTyping(event)
               || keepsFromShortcuts(event);
    }
    bool keepsFromShortcuts(const QKeyEvent& event) const;
    void beginTyping(const QKeyEvent& event);
    void typeFirstPoint(const QString& text);
    bool releaseLocked();
    void cancelGesture();
    void steer();
    void steer(Pointer& pointer) const;
    void followGauge();
    bool arrow(const QKeyEvent& event);
    bool escape();
    std::optional<app::Snap> snapAt(const app::Point& raw, Qt::KeyboardModifiers modifiers) const;
    Pointer pointerAt(const QPointF& screen, Qt::MouseButtons buttons,
                      Qt::KeyboardModifiers modifiers);
    /// The part of what stepsChanged() reports that a tool can change.
    struct Steps {
        bool undo = false, redo = false, takeBack = false;
        std::size_t points = 0;
        friend bool operator==(const Steps&, const Steps&) = default;
    };
    Steps steps() const;
    void tellSteps(const Steps& before);
    /// Runs `call`, then signals what the tool changed.
    void withTool(const std::function<void()>& call);

    app::Session& session_;
    Navigation navigation_;
    app::Picking picking_;
    mutable TextBoxes textBoxes_; ///< computed on demand
    app::Display shown_;          ///< except the algorithm, which each pane has of its own
    Look look_, paperLook_;
    app::View toolView_; ///< the view that tools change; compared with the real one after each call
    Workbench bench_;
    const ToolInfo* toolInfo_ = nullptr;
    std::unique_ptr<Tool> tool_;
    app::Snapper snapper_;
    app::SnapTo snapTo_ = app::SnapTo::usual();
    bool snaps_ = true;
    app::SnapTo snapNow_ = snapTo_; ///< Nothing while snapping is off
    std::optional<Pointer> pointer_;
    GuideDrag guide_; ///< from a ruler
    std::optional<app::Readout> readout_;
    bool typing_ = false;
    QRectF readoutPlace_, capsulePlace_;
    std::optional<app::Snap> snap_;
    std::optional<QPointF> panningFrom_;
    bool space_ = false;
    /// The left button was last pressed on the offered handle, so the tool does not get the click.
    bool onOffer_ = false;
    /// Runs while the object being drawn has points not yet reported by stepsChanged().
    QTimer growing_;
    app::ObjectRanges inspectedSelection_; ///< the last one that inspectOnly() has seen
    std::shared_ptr<app::DrawingPictures> drawings_ = std::make_shared<app::DrawingPictures>();
    std::uint64_t revision_ = 1; ///< of the display, the selection and the look
    double unitSize_ = 0;        ///< millimetres per user unit
    std::optional<std::chrono::steady_clock::time_point> turnEnds_; ///< for waiting
};

} // namespace ui
