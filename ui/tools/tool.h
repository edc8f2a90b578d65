// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "app/view/grips.h"
#include "app/view/picking.h"
#include "app/view/snap.h"
#include "app/view/view.h"
#include "ui/look.h"

#include <QCursor>
#include <QKeyEvent>
#include <QKeySequence>
#include <QPainter>

#include <memory>
#include <span>
#include <string_view>

namespace ui {

/// The pointer over the canvas.
struct Pointer {
    app::Point position; ///< in the drawing, after snapping
    app::Point raw;      ///< in the drawing, as it is
    app::Point screen;   ///< logical pixels of the canvas
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers modifiers;
};

/// What a tool works on. It changes the document by pushing commands on session.history, and in no
/// other way; it pans and zooms through `view`.
struct Workbench {
    app::Session& session;
    app::View& view;
    const app::Picking& picking;
    const Look& look;

    QPointF onScreen(const app::Point& p) const
    {
        const app::Point s = view.toScreen(p);
        return {s.x, s.y};
    }
    /// A length of the screen in the drawing.
    double inDrawing(double pixels) const { return pixels / view.zoom; }
};

/// Pixels: how near the pointer must come to a line, and how far it must go before it drags.
constexpr double reach = 6, dragDistance = 3;

/// How far an arrow key moves things: a millimetre on paper, with Shift ten.
double nudge(const Workbench& bench, Qt::KeyboardModifiers modifiers);

/// Turns what the pointer and keys do into commands: one gesture, one command. In the middle of it
/// the session's preview says what it would be. The canvas calls it; it never calls the canvas,
/// which repaints after every call.
class Tool {
public:
    virtual ~Tool() = default;
    virtual void press(const Pointer&, Workbench&) {}
    virtual void move(const Pointer&, Workbench&) {} ///< also without a button: hovering
    virtual void release(const Pointer&, Workbench&) {}
    virtual void doubleClick(const Pointer&, Workbench&) {}
    virtual bool key(QKeyEvent&, Workbench&) { return false; } ///< true: used up
    virtual void leave(Workbench&) {}           ///< the pointer has left: nothing is under it
    virtual void cancel(Workbench&) {}          ///< drops the gesture, with all that it has made
    virtual bool busy() const { return false; } ///< in the middle of a gesture
    /// Esc, another tool, or the document is wanted: what can be kept of a gesture becomes one
    /// command.
    virtual void end(Workbench& bench) { cancel(bench); }

    /// A gesture of several steps takes them back and puts them back one by one, in place of Undo
    /// and Redo in the history.
    virtual bool canTakeBack() const { return false; }
    virtual void takeBack(Workbench&) {}
    virtual bool canPutBack(const Workbench&) const { return false; }
    virtual void putBack(Workbench&) {}
    virtual QString stepText() const { return {}; } ///< what such a step is called in the menu
    /// What end() would keep now; nothing: no object.
    virtual std::optional<app::Subpath> pathInHand() const { return std::nullopt; }
    virtual std::size_t pointsInHand() const { return 0; } ///< of the path that is being drawn

    virtual QCursor cursor(const Workbench&) const { return Qt::CrossCursor; }
    virtual app::SnapTo snapsTo() const { return app::SnapTo::All; }
    virtual bool showsGrips() const { return false; } ///< of the clip window
    /// The grip of the clip window that a press would drag: it is lit.
    virtual std::optional<app::Grip> litGrip() const { return std::nullopt; }
    /// The segment that a press would take: it is lit.
    virtual std::optional<std::size_t> litSegment() const { return std::nullopt; }
    /// What to say in the status bar just now; empty: the tool's usual hint.
    virtual QString hint(const Workbench&) const { return {}; }
    virtual bool draws() const { return false; } ///< new objects, in the session's pen
    /// What to draw over the drawing, in logical pixels of the canvas.
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
    Group group = Group::Same; ///< New: in bars and menus, a line goes before it
};

/// Every tool, in the order of the tool bar.
std::span<const ToolInfo> tools();
const ToolInfo* findTool(std::string_view key);

} // namespace ui
