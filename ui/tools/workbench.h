// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/readout.h"
#include "app/session/session.h"
#include "app/view/handles.h"
#include "app/view/picking.h"
#include "app/view/snapping/snapper.h"
#include "app/view/view.h"
#include "ui/look/look.h"

#include <QPointF>

#include <map>
#include <optional>
#include <string_view>
#include <typeindex>

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
    /// Width and height of what each tool made last, by its class.
    std::map<std::type_index, app::Point> lastSides{};
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

/// The font of the next text: the last one if there is still such a font.
QString fontOfNext(const Workbench& bench);

/// In logical pixels: how near to a line the pointer hits it, how far it must move to start a drag,
/// and how near it must be to snap.
constexpr double reach = 6, dragDistance = 3, snapReach = 8;

/// How far an arrow key moves objects, in drawing units: 1 mm on paper, with Shift 10 mm.
double nudge(const Workbench& bench, Qt::KeyboardModifiers modifiers);

} // namespace ui
