// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool_parts.h"

namespace ui {

/// A new object with the session's stroke style.
app::Object objectOf(const app::Session& session, std::span<const app::Subpath> subpaths,
                     app::Recipe recipe = {});

/// A new object of this path, as it is kept before it is finished.
app::ObjectInHand inHand(const Workbench& bench, const app::Subpath& path);

/// Adds a new object as one undo step; shared by the drawing tools.
void draw(Workbench& bench, std::vector<app::Subpath> paths, const QString& undoText,
          app::Recipe recipe = {});

bool isText(const app::Session& session, std::size_t object);

/// Pushes a step, and keeps the inspected line if the step only changes its coordinates.
void pushKeepingInspected(app::Session& session, app::UndoCommand* step);

/// The colour as the canvas shows it: visible on dark paper.
QColor shownColour(const app::Colour& colour, const Workbench& bench);

/// Paints the preview of a path in the colour of the session's stroke style.
void preview(QPainter& painter, const Workbench& bench, const app::Subpath& path);
void preview(QPainter& painter, const Workbench& bench, std::span<const app::Subpath> paths,
             const app::Style& style);

/// Paints a mark on each point that was placed.
void markPoints(QPainter& painter, const Workbench& bench, std::span<const app::Point> points);

/// Numbers for a gesture from this point, in the drawing's unit.
app::Gauge gaugeFrom(const app::Point& from, const app::GestureMeasure& measure,
                     const Workbench& bench);
/// Coordinates for a first point; "@10,20" refers to the last point that was drawn or typed.
app::Gauge gaugeOfStart(const Workbench& bench);

/// The numbers that a tool keeps for its next object; `usual` until it has drawn one.
app::Numbers keptBy(std::string_view tool, const Workbench& bench, const app::Numbers& usual);

/// Whether the pointer has moved far enough for a drag.
bool dragged(const app::Point& from, const Pointer& to);

/// The meaning of Shift and Alt for shapes dragged from corner to corner.
app::Proportion proportionOf(Qt::KeyboardModifiers modifiers);
app::Anchor anchorOf(Qt::KeyboardModifiers modifiers);

} // namespace ui
