// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"
#include "app/drawing/transformation.h"
#include "app/session/digits.h"
#include "app/session/pasted_text.h"
#include "app/session/session.h"
#include "app/view/capsule_place.h"
#include "app/view/frame_times.h"
#include "app/view/snapping/snap_to.h"
#include "app/view/view.h"
#include "ui/canvas/backend.h"
#include "ui/canvas/navigation.h"

#include <QHash>
#include <QKeySequence>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace app {
struct ObjectInHand;
}

namespace ui {

/// The drawing on the screen, with rulers and the current tool. All segments are clipped at every
/// frame. Colours follow the palette (ui/look/look.h). focusProxy() is the widget that receives the
/// keyboard.
///
/// The canvas may be divided into panes side by side, each with its own algorithm, all with the
/// same drawing, view, clip window and gesture. The session's variant clips in the active pane.
class Canvas : public QWidget {
    Q_OBJECT

public:
    /// Automatic: OpenGL if a graphics card supports it, else the raster canvas.
    explicit Canvas(app::Session& session, Backend backend = Backend::Automatic,
                    QWidget* parent = nullptr);
    ~Canvas() override;

    Backend backend() const;       ///< the one in use, never Automatic
    QString backendReason() const; ///< a sentence: which backend is used, and why

    const app::View& view() const;
    double zoom() const; ///< 1 = 100 %: 1 mm on paper is 96 / 25.4 logical pixels

    void setTool(std::string_view key); ///< one of ui::tools()
    std::string_view tool() const;
    QString toolHint() const;       ///< the tool's current hint
    app::DigitUse digitUse() const; ///< what a digit does now
    /// Those of tools and views. `own`: the keys of all commands, for those that it understands.
    void leaveKeysToCommands(const QHash<QString, QList<QKeySequence>>& own);
    bool digitsChoose() const; ///< whether digits choose the algorithm, outside gestures

    /// Undo or redo one step: a corner of the polyline being drawn, else a step of the history.
    void setHint(const QString& hint); ///< of what lies over it; empty: toolHint() is the tool's
    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    void goToStep(int index); ///< undoes or redoes until so many steps are done; ends the gesture
    QString undoText() const; ///< the name of that step
    QString redoText() const;
    void cancelGesture(); ///< everything is as it was before
    /// Ends the gesture and keeps what is complete, so that the document is as it is seen.
    void endGesture();
    std::optional<app::ObjectInHand> pendingObject() const; ///< what endGesture() would keep now

    /// The kinds of places that the pointer snaps to, while snapping is on.
    app::SnapTo snapping() const;
    void setSnapping(app::SnapTo to);
    bool snaps() const; ///< whether snapping is on
    void switchSnapping(bool on);
    bool actsOnWindow() const; ///< whether keys are for the chosen clip window
    /// Where what is chosen has its controls.
    app::CapsuleHome capsuleHome() const;
    void setCapsuleHome(app::CapsuleHome home);
    /// The row of the options bar for them, which a room above makes.
    void setCapsuleBar(QWidget& bar);
    void narrowCapsuleInBar(bool narrow); ///< there is not room for all of its parts
    bool hasCapsuleInBar() const;         ///< whether some are shown there now
    /// The numbers that a tool keeps for its next object; empty: its usual ones.
    std::optional<app::Numbers> keptNumbers(std::string_view tool) const;
    /// `tool` outlives the canvas: it is a key of a catalogue.
    void keepNumbers(std::string_view tool, const app::Numbers& numbers);
    QString keptFont() const; ///< of the next text
    /// The next text, without letters, at a point of the active pane.
    app::PastedText textAt(const QPointF& point) const;
    void keepFont(const QString& font);
    /// Whether capsules are on, and all their parts have room.
    bool hasWholeCapsule() const;
    /// The first controls in the capsule of selected objects, which a room above makes. Once.
    void setStyleControls(QWidget& style, std::function<void()> follow);
    /// Moves, rotates, scales or skews the selection by the pointer and by typed numbers.
    void transform(const app::Transformation& kind);

    /// Selected objects that are dragged, perhaps out of the canvas.
    struct Carried {
        QPoint at; ///< on the screen
        Qt::KeyboardModifiers modifiers;
        bool dropped;
    };
    /// Told at each move; true: what is there takes them if they are dropped, and they stay here as
    /// they were.
    void setCarrier(std::function<bool(const Carried&)> carrier);

    /// Selects what is at a position of the canvas, unless it is selected already, for the menu of
    /// the right button. False: no object is there.
    bool selectAt(const QPoint& position);
    /// Chooses the clip window whose outline or name is there; false: there is none.
    bool chooseWindowAt(const QPoint& position);

    /// While the window keeps its size, the zoom and the point at the upper left corner stay when
    /// the canvas gets another size, also if the view was fitted.
    void keepCorner();
    void fitDrawing();   ///< everything that is drawn; nothing is: the page
    void fitPage();      ///< the page and everything that is drawn
    void fitSelection(); ///< the drawing if nothing is selected
    void fitWindow();
    /// `view` has the canvas's size; previousView() returns from it.
    void go(const app::View& view);
    void zoomBy(double factor);
    void setZoom(double zoom); ///< in the unit of zoom()
    void previousView();
    void nextView();

    const app::Panes& panes() const;
    /// What several panes show, or one in a workspace that compares, does not cut (comparing.h).
    void setPanes(const app::Panes& panes);
    void closePane(std::size_t pane);
    void activatePane(std::size_t pane);
    /// The widget that shows a pane's drawing; null if there is no room for the pane.
    QWidget* paneSurface(std::size_t pane) const;

    /// Waits until the picture is shown in full quality; used by tests and screenshots.
    void settle();

    /// Where the drawing begins, right of and below rulers and headings; in logical pixels.
    QPoint drawingCorner() const;

signals:
    void frameShown(const app::FrameTimes& times); ///< the times of the active pane's frame
    /// The pointer's position in the drawing; empty: the pointer has left.
    void pointerMoved(std::optional<app::Point> position);
    void hint(const QString& text); ///< the tool's current hint; empty: its usual one
    void toolChanged();
    /// The effect of undo() and redo(), or the object being drawn, has changed.
    void stepsChanged();
    void viewChanged();
    void snappingChanged();    ///< the kinds, or whether it is on
    void capsuleSwitched();    ///< its home has changed, or between whole and fewer parts
    void capsuleBarOutdated(); ///< those in the options bar need more or less room
    /// The menu of the chosen clip window is wanted, its upper right corner at a point of the
    /// screen.
    void windowMenuWanted(const QPoint& corner);
    void objectMenuWanted(const QPoint& corner); ///< that of the selected objects
    void refused(const QString& sentence);       ///< a length typed there is not one
    void taken();                                ///< it is valid again
    void panesChanged(); ///< the panes' number, variants or active pane have changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addPane();
    void layOut();
    bool changeCount(std::size_t before);
    void followChoice();
    void keepPanes(const app::Panes& panes);
    void followComparing(std::size_t panes);
    bool activates(const QEvent& event) const;
    bool carriesAway(const QEvent& event);
    std::optional<QPoint> onDrawing(const QPoint& position) const; ///< of the pane's surface there

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace ui
