// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/panes.h"
#include "app/session/session.h"
#include "app/view/snap.h"
#include "app/view/view.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <string_view>

namespace ui {

enum class Backend : std::uint8_t { Automatic, OpenGL, Raster };

/// What scrolls. Automatic: a touchpad where the system reports its pixels.
enum class PointingDevice : std::uint8_t { Automatic, Mouse, Touchpad };

/// What the last frame took. `drawMs` is everything but the clipping: building the picture and
/// painting it.
struct FrameTimes {
    double clipMs = 0, drawMs = 0;
    std::uint64_t clipNanoseconds = 0;
    std::size_t visible = 0, total = 0;
    std::optional<app::Variant> choice{}; ///< what clipped
    bool painting = false; ///< its picture is not ready: the last one is shown, moved and scaled
};

/// The drawing on the screen, with its rulers, and the tool that works on it. All segments are
/// clipped at every frame. Colours follow the palette (ui/look.h). The widget that takes
/// the keyboard is focusProxy().
///
/// Instead of one there may be panes side by side, each with its own algorithm, all with the same
/// drawing, view, clip window and gesture. What is chosen in the session clips in the active pane.
class Canvas : public QWidget {
    Q_OBJECT

public:
    /// Automatic: OpenGL where a graphics card does it, else the raster canvas.
    explicit Canvas(app::Session& session, Backend backend = Backend::Automatic,
                    QWidget* parent = nullptr);
    ~Canvas() override;

    Backend backend() const;       ///< the one in use, never Automatic
    QString backendReason() const; ///< a sentence: which one, and why

    const app::View& view() const;
    double zoom() const; ///< 1: 100 %, a millimetre on paper is one on the screen's logical scale

    void setTool(std::string_view key); ///< one of ui::tools()
    std::string_view tool() const;
    QString toolHint() const; ///< what it says now

    /// One step back or forth: a corner of the polyline in hand, else of the history.
    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    QString undoText() const; ///< what that step is called
    QString redoText() const;
    /// Keeps what can be kept of the gesture: the document is wanted as it is seen.
    void endGesture();
    std::optional<app::ObjectInHand> objectInHand() const; ///< what endGesture() would keep now

    void setSnapping(app::SnapTo to);
    void setPointingDevice(PointingDevice device);

    void fitDrawing();   ///< the page and everything that is drawn
    void fitSelection(); ///< nothing selected: the drawing
    void fitWindow();
    void go(const app::View& view); ///< of its size; remembered for previousView()
    void zoomBy(double factor);
    void setZoom(double zoom); ///< as zoom()
    void previousView();
    void nextView();

    const app::Panes& panes() const;
    void setPanes(const app::Panes& panes);
    void activatePane(std::size_t pane);
    /// The widget that shows a pane's drawing; null where it has no room.
    QWidget* paneSurface(std::size_t pane) const;

    /// Waits until the picture is shown in full quality (tests, screenshots).
    void settle();

signals:
    void frameShown(const ui::FrameTimes& times);          ///< its times, in the active pane
    void pointerMoved(std::optional<app::Point> position); ///< in the drawing; nothing: left
    void hint(const QString& text); ///< what the tool says now; empty: its usual hint
    void toolChanged();
    void stepsChanged(); ///< what undo() and redo() do, or what is in hand
    void viewChanged();
    void panesChanged(); ///< how many, what clips there, or which is the active one

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addPane();
    void layOut();
    void followChoice();
    bool activates(const QEvent& event) const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace ui
