// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

namespace ui {

/// The colour of a window's outline: its own, visible on the page, or that of all windows.
QColor colourOf(const app::ClipWindow& window, const Controller& controller);

/// The name of a clip window that is not the chosen one, on the canvas.
struct WindowTag {
    QRectF place;
    QString text;
    QColor colour;
    std::size_t number; ///< of the window
};

/// The tags of all visible windows except the chosen one; none if there are too many to tell them
/// apart. `font` is the painter's.
std::vector<WindowTag> windowTags(const Controller& controller, const QFont& font);
void paintTags(QPainter& painter, const Controller& controller);

} // namespace ui
