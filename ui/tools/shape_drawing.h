// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// A new object in the session's pen.
app::Object objectOf(const app::Session& session, std::span<const app::Subpath> subpaths,
                     app::Recipe recipe = {});

/// What the drawing tools share: a new object, pushed as one step.
void draw(Workbench& bench, std::vector<app::Subpath> paths, const QString& undoText,
          app::Recipe recipe = {});

/// The preview of a path, in the pen's ink.
void preview(QPainter& painter, const Workbench& bench, const app::Subpath& path);

/// `to`, turned so that the direction from `from` is a multiple of 15 degrees.
app::Point turned(const app::Point& from, const app::Point& to);

/// Whether the pointer went far enough for a drag.
bool dragged(const app::Point& from, const Pointer& to);

/// Shift and Alt, for what is drawn from corner to corner.
app::Proportion proportionOf(Qt::KeyboardModifiers modifiers);
app::Anchor anchorOf(Qt::KeyboardModifiers modifiers);

} // namespace ui
