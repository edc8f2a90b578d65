// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/workbench.h"

#include <QCursor>
#include <QKeySequence>
#include <QPainter>

#include <memory>
#include <span>

namespace ui {

/// Turns pointer events into commands: one gesture, one command. During a gesture the session's
/// preview holds its result so far. The canvas calls the tool and repaints after every call; the
/// tool never calls the canvas. What only some tools can do are parts (tool_parts.h), from which a
/// tool inherits, too.
class Tool {
public:
    virtual ~Tool() = default;
    virtual void press(const Pointer&, Workbench&) {}
    virtual void move(const Pointer&, Workbench&) {} ///< also without a button, for hovering
    virtual void release(const Pointer&, Workbench&) {}
    virtual void doubleClick(const Pointer&, Workbench&) {}
    virtual void leave(Workbench&) {}           ///< the pointer has left: nothing is hovered
    virtual void cancel(Workbench&) {}          ///< discards the gesture and everything it has made
    virtual bool busy() const { return false; } ///< a gesture is in progress
    /// Called on Esc, when the tool changes, and before the document is read: pushes the completed
    /// part of the gesture as one command.
    virtual void end(Workbench& bench) { cancel(bench); }
    /// The current hint in the status bar; empty: the tool's usual hint.
    virtual QString hint(const Workbench&) const { return {}; }
    virtual QCursor cursor(const Workbench&) const { return Qt::CrossCursor; }
    /// Paints over the drawing, in logical pixels of the canvas.
    virtual void paint(QPainter&, const Workbench&) const {}

    /// A part of the tool; of one that does not have it, a part that does nothing.
    template <class Part>
    Part& as()
    {
        return partOf<Part>(this);
    }
    template <class Part>
    const Part& as() const
    {
        return partOf<const Part>(this);
    }

private:
    template <class Part, class Self>
    static Part& partOf(Self* self)
    {
        static Part none{};
        auto* own = dynamic_cast<Part*>(self);
        return own ? *own : none;
    }
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

    bool draws() const { return options == Options::Stroke; } ///< objects, in the session's style
    bool beginsAtPoint() const { return draws() || options == Options::Window; } ///< a typed one
    bool arranges() const { return options == Options::Arranging; } ///< chooses whole objects
    bool showsHandles() const { return arranges() || options == Options::Window; } ///< of a window
};

/// Every tool, in the order of the tool bar.
std::span<const ToolInfo> tools();
const ToolInfo* findTool(std::string_view key);

} // namespace ui
