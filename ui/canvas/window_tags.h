// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/held_tool.h"

namespace ui {

/// The colour of a window's outline: its own, visible on the page, or that of all windows.
QColor colourOf(const app::ClipWindow& window, const Workbench& bench);

/// The name of a clip window that is not the chosen one, on the canvas.
struct WindowTag {
    QRectF place;
    QString text;
    QColor colour;
    std::size_t number; ///< of the window
};

/// The tags of all visible windows except the chosen one; none if there are too many to tell them
/// apart. `font` is the painter's.
std::vector<WindowTag> windowTags(const HeldTool& held, const QFont& font);
void paintTags(QPainter& painter, const HeldTool& held);
/// The clip window whose name is there, while no gesture goes on.
std::optional<std::size_t> nameAt(const QPointF& screen, const HeldTool& held);
/// The clip window whose name takes a click there.
std::optional<std::size_t> tagAt(const QPointF& screen, const HeldTool& held);
/// Chooses the clip window whose outline, handle or name is there; false: there is none, or an
/// object comes first.
bool chooseWindowAt(const QPointF& screen, HeldTool& held);

} // namespace ui
