// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/transformation.h"
#include "app/session/session.h"
#include "app/view/handles.h"
#include "app/view/picking.h"
#include "app/view/snapping/snapper.h"
#include "app/view/view.h"
#include "ui/look/look.h"

#include <QCursor>
#include <QKeyEvent>
#include <QKeySequence>
#include <QPainter>

#include <map>
#include <memory>
#include <span>
#include <string_view>

namespace ui {

/// The pointer over the canvas.
struct Pointer {
    app::Point position; ///< in the drawing, after snapping, held at what is typed
    app::Point raw;      ///< in the drawing, before snapping
    app::Point screen;   ///< logical pixels of the canvas
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers modifiers;
    app::Point steered;     ///< in the drawing, after snapping
    app::Numbers numbers{}; ///< of the gesture, as the readout shows them
    bool held = false;      ///< something is typed or locked
};

/// What a tool works on. A tool changes the document only by pushing commands on session.history;
/// it pans and zooms through `view`.
struct Workbench {
    app::Session& session;
    app::View& view;
    const app::Picking& picking;
    const Look& look; ///< of what lies on the drawing
    const app::Snapper& snapper;
    const app::SnapTo& snapTo; ///< the kinds that are on; Nothing: snapping is off
    /// The key of the tool to go on with, which replaces this one after the call; empty: this one.
    std::string_view nextTool{};
    /// The object that the next tool begins with; empty: none. The tool takes it.
    std::optional<std::size_t> nextObject{};
    /// The numbers that tools keep for their next object, by the key of the tool.
    std::map<std::string_view, app::Numbers> kept{};
    QString keptFont{};       ///< of the last text that was typed; empty: none was
    app::FontFace keptFace{}; ///< that was chosen; a font that lacks it does not change it
    /// The point that was drawn or typed last in this drawing; empty: none was.
    std::optional<app::Point> lastPoint{};

    QPointF onScreen(const app::Point& p) const
    {
        const app::Point s = view.toScreen(p);
        return {s.x, s.y};
    }
    /// Converts a length from screen pixels to drawing units.
    double inDrawing(double pixels) const { return pixels / view.zoom; }

    /// The points of the grid; empty: it is hidden.
    std::optional<app::GridPoints> grid() const;

    /// The guides of the page; null: they are hidden.
    const app::Guides* guides() const;

    /// How far a thing goes that is dragged by `by`, and what it snaps to on the way: by its own
    /// points and edges, not to the objects `without` and that clip window. Ctrl suspends
    /// snapping.
    app::MovedSnap moved(const app::OwnPoints& own, const app::Point& by,
                         Qt::KeyboardModifiers modifiers, const app::ObjectRanges& without = {},
                         app::SnapTo allowed = app::SnapTo::All,
                         std::optional<std::size_t> withoutWindow = {}) const;
};

/// In logical pixels: how near to a line the pointer hits it, how far it must move to start a drag,
/// and how near it must be to snap.
constexpr double reach = 6, dragDistance = 3, snapReach = 8;

/// How far an arrow key moves objects, in drawing units: 1 mm on paper, with Shift 10 mm.
double nudge(const Workbench& bench, Qt::KeyboardModifiers modifiers);

/// A text that is being typed, as the field on the canvas shows it.
struct TypedText {
    app::TextRecipe recipe;
    QString remark;          ///< what is missing; may be empty
    clipping::Window bounds; ///< of its letters, in the drawing
};

/// Turns pointer and key events into commands: one gesture, one command. During a gesture the
/// session's preview holds its result so far. The canvas calls the tool and repaints after every
/// call; the tool never calls the canvas.
class Tool {
public:
    virtual ~Tool() = default;
    virtual void takeUp(Workbench&) {}  ///< the tool was chosen
    virtual void putAway(Workbench&) {} ///< another tool is chosen; after end()
    virtual void press(const Pointer&, Workbench&) {}
    virtual void move(const Pointer&, Workbench&) {} ///< also without a button, for hovering
    virtual void release(const Pointer&, Workbench&) {}
    virtual void doubleClick(const Pointer&, Workbench&) {}
    /// Selects what the menu of the right button is about, unless it is selected. False: the tool
    /// finds nothing of its own there.
    virtual bool selectForMenu(const Pointer&, Workbench&) { return false; }
    virtual bool key(QKeyEvent&, Workbench&) { return false; } ///< true: consumed
    /// Whether the key belongs to the gesture, before the shortcut of a command.
    virtual bool wants(const QKeyEvent&, const Workbench&) const { return false; }
    virtual void leave(Workbench&) {}           ///< the pointer has left: nothing is hovered
    virtual void cancel(Workbench&) {}          ///< discards the gesture and everything it has made
    virtual bool busy() const { return false; } ///< a gesture is in progress
    /// Called on Esc, when the tool changes, and before the document is read: pushes the completed
    /// part of the gesture as one command.
    virtual void end(Workbench& bench) { cancel(bench); }

    /// During a gesture of several steps, Undo and Redo act on these steps one by one instead of on
    /// the history.
    virtual bool canTakeBack() const { return false; }
    virtual void takeBack(Workbench&) {}
    virtual bool canPutBack(const Workbench&) const { return false; }
    virtual void putBack(Workbench&) {}
    /// The step's name in the Undo and Redo menu entries.
    virtual QString stepText() const { return {}; }
    /// The path that end() would keep now; empty: none.
    virtual std::optional<app::Subpath> pendingPath() const { return std::nullopt; }
    /// The object that end() would add or change, where it is more than a path; empty: none.
    virtual std::optional<app::Object> pendingObject(const Workbench&) const
    {
        return std::nullopt;
    }
    /// The object that pendingObject() replaces; empty: it is a new one.
    virtual std::optional<std::size_t> replacedObject(const Workbench&) const
    {
        return std::nullopt;
    }
    /// Number of points of the path being drawn, or of changes of the text being typed.
    virtual std::size_t pendingPoints() const { return 0; }

    /// Which numbers may be typed now, and what they refer to; empty: none.
    virtual std::optional<app::Gauge> gauge(const Workbench&) const { return std::nullopt; }
    /// Ends the gesture, or its current step, with typed numbers.
    virtual void accept(const app::GestureEnd&, Workbench&) {}
    /// Goes on with the last gesture in place of what it has drawn, so that typed numbers change
    /// it. Does nothing if anything else has happened since.
    virtual void reopen(Workbench&) {}
    virtual bool corrects() const { return false; } ///< a finished gesture is open again
    /// During a correction: a typed point is not meant for it, but begins the next gesture.
    virtual bool pointBegins() const { return false; }

    /// What is being typed; empty: no text.
    virtual std::optional<TypedText> typedText() const { return std::nullopt; }
    virtual void typeText(const app::TextRecipe&, Workbench&) {} ///< text, font or size
    virtual void finishText(Workbench& bench) { end(bench); }    ///< by Enter or Esc

    /// Begins to move, rotate, scale or skew the selection, if the tool can.
    virtual void transform(const app::Transformation&, const Pointer&, Workbench&) {}

    virtual QCursor cursor(const Workbench&) const { return Qt::CrossCursor; }
    virtual app::SnapTo snapsTo() const { return app::SnapTo::All; }
    virtual void leaveOutMoved(app::SnapQuery&) const {} ///< what is dragged snaps to other things
    /// Where the thing that is being moved snaps; null: nothing is moved.
    virtual const app::MovedSnap* snapped() const { return nullptr; }
    virtual bool showsHandles() const { return false; } ///< the clip window's handles
    virtual bool movesEnds() const { return false; }    ///< of the inspected line (end_drag.h)
    /// The hovered handle of the clip window, which a press would drag.
    virtual std::optional<app::Handle> hoveredHandle() const { return std::nullopt; }
    /// The hovered segment, which a press would select.
    virtual std::optional<std::size_t> hoveredSegment() const { return std::nullopt; }
    /// The current hint in the status bar; empty: the tool's usual hint.
    virtual QString hint(const Workbench&) const { return {}; }
    virtual bool draws() const { return false; } ///< adds objects with the session's stroke style
    /// Paints over the drawing, in logical pixels of the canvas.
    virtual void paint(QPainter&, const Workbench&) const {}
};

/// One row of the catalogue of tools.
struct ToolInfo {
    std::string_view key; ///< the icon is :/icons/KEY.svg
    QString name;
    QString hint; ///< in the status bar while the tool is chosen
    QKeySequence shortcut;
    std::unique_ptr<Tool> (*make)();
    enum class Group : std::uint8_t { Same, New };
    Group group = Group::Same; ///< New: a separator precedes it in bars and menus
    /// What the bar across the top has for it. Stroke: that of what it draws.
    enum class Options : std::uint8_t { Stroke, Arranging, Nodes, View, Window };
    Options options = Options::Stroke;
};

/// Every tool, in the order of the tool bar.
std::span<const ToolInfo> tools();
const ToolInfo* findTool(std::string_view key);

} // namespace ui
