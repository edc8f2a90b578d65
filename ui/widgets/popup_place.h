// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace ui {

/// The top left corner of a small window of that size below a widget, or above it if there is no
/// room; always on the screen.
inline QPoint placeBelow(const QWidget& widget, const QSize& size)
{
    constexpr int gap = 2; // logical pixels
    const QRect screen = widget.screen()->availableGeometry();
    const QPoint below = widget.mapToGlobal(QPoint(0, widget.height() + gap));
    const int left = std::clamp(below.x(), screen.left(),
                                std::max(screen.left(), screen.right() - size.width()));
    const bool fits = below.y() + size.height() <= screen.bottom();
    const int top = fits ? below.y() : widget.mapToGlobal(QPoint(0, -gap)).y() - size.height();
    return {left, std::max(screen.top(), top)};
}

} // namespace ui
