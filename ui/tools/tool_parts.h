// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_in_hand.h"
#include "app/drawing/transformation.h"
#include "ui/tools/tool.h"

#include <QKeyEvent>

// What only some tools can do, as the canvas asks for it: Tool::as().

namespace ui {

struct ToolPart {
    virtual ~ToolPart() = default;
};

/// Prepares something when it is chosen.
struct TakenUp : ToolPart {
    virtual void takeUp(Workbench&) {}
    virtual void putAway(Workbench&) {} ///< another tool is chosen; after end()
};

struct TakesKeys : ToolPart {
    virtual bool key(QKeyEvent&, Workbench&) { return false; } ///< true: consumed
    /// Whether the key belongs to the gesture, before the shortcut of a command.
    virtual bool wants(const QKeyEvent&, const Workbench&) const { return false; }
};

/// A gesture of several steps: Undo and Redo act on them one by one instead of on the history.
struct HasSteps : ToolPart {
    virtual bool canTakeBack() const { return false; }
    virtual void takeBack(Workbench&) {}
    virtual bool canPutBack(const Workbench&) const { return false; }
    virtual void putBack(Workbench&) {}
    /// The step's name in the Undo and Redo menu entries.
    virtual QString stepText() const { return {}; }
};

/// Draws an object piece by piece, so that it is kept in the journal before it is finished.
struct HasUnfinished : ToolPart {
    /// What end() would keep now; empty: nothing.
    virtual std::optional<app::ObjectInHand> unfinished(const Workbench&) const
    {
        return std::nullopt;
    }
    /// Number of its points, or of changes of the text being typed.
    virtual std::size_t unfinishedPoints() const { return 0; }
};

/// Its gestures are exact by typed numbers.
struct TypesNumbers : ToolPart {
    /// Which numbers may be typed now, and what they refer to; empty: none.
    virtual std::optional<app::Gauge> gauge(const Workbench&) const { return std::nullopt; }
    /// Whether Enter opens them without a gesture, as nothing else has a use for it.
    virtual bool enterOpens(const Workbench&) const { return true; }
    /// Ends the gesture, or its current step, with typed numbers.
    virtual void accept(const app::GestureEnd&, Workbench&) {}
    /// Goes on with the last gesture in place of what it has drawn, so that typed numbers change
    /// it. Does nothing if anything else has happened since.
    virtual void reopen(Workbench&) {}
    virtual bool corrects() const { return false; } ///< a finished gesture is open again
    /// During a correction: a typed point is not meant for it, but begins the next gesture.
    virtual bool pointBegins() const { return false; }
};

/// A text that is being typed, as the field on the canvas shows it.
struct TypedText {
    app::TextRecipe recipe;
    QString remark;          ///< what is missing; may be empty
    clipping::Window bounds; ///< of its letters, in the drawing
};

struct TypesText : ToolPart {
    /// What is being typed; empty: no text.
    virtual std::optional<TypedText> typedText() const { return std::nullopt; }
    virtual void typeText(const app::TextRecipe&, Workbench&) {} ///< text, font or size
    virtual void finishText(Workbench&) {}                       ///< by Enter or Esc
};

/// Snaps to less than everything, or moves something that snaps by its own points.
struct Snaps : ToolPart {
    /// Takes out of the query what the pointer does not snap to: kinds, and what is dragged.
    virtual void limit(app::SnapQuery&) const {}
    /// Where the thing that is being moved snaps; null: nothing is moved.
    virtual const app::MovedSnap* snapped() const { return nullptr; }
};

/// Marks what a press would choose.
struct Hovers : ToolPart {
    virtual std::optional<app::Handle> hoveredHandle() const
    {
        return std::nullopt;
    } ///< a window's
    virtual std::optional<std::size_t> hoveredSegment() const { return std::nullopt; }
};

struct Transforms : ToolPart {
    /// Begins to move, rotate, scale or skew the selection.
    virtual void transform(const app::Transformation&, const Pointer&, Workbench&) {}
    virtual bool movesSelection() const { return false; } ///< by a drag, now
};

struct SelectsForMenu : ToolPart {
    /// Selects what the menu of the right button is about, unless it is selected. False: the tool
    /// finds nothing of its own there.
    virtual bool selectForMenu(const Pointer&, Workbench&) { return false; }
};

} // namespace ui
