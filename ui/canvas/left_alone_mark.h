// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <QPainterPath>

namespace ui {

/// Whether a pane says at each window that its variant leaves alone why; not if there are too many
/// of them.
inline bool hasReasons(const Pane& pane)
{
    constexpr std::size_t most = 8;
    return !pane.leftAlone.empty() && pane.leftAlone.size() <= most;
}

/// Paints the outline, on screen, of a clip window that a pane's variant leaves alone: dotted, and
/// its inside faded.
void paintLeftAlone(QPainter& painter, const Controller& controller, const QPainterPath& outline);

/// A box for each window that the pane's variant leaves alone, which says why. It covers neither
/// another window nor a name.
void paintReasons(QPainter& painter, const Controller& controller, const Pane& pane);

} // namespace ui
