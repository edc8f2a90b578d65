// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QString>

#include <optional>
#include <span>

namespace app {

/// Where a window is when it is not maximized: the corner of its frame and the size inside of it,
/// in logical pixels.
struct WindowPlace {
    QRect rect;
    bool maximized = false;
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

/// "100,80 1280x800" or "100,80 1280x800 maximized": how the settings hold it.
QString placeText(const WindowPlace& place);

/// Nothing unless `text` is exactly such a text, with a size from 1 to 100,000 and a corner within
/// ±100,000 pixels.
std::optional<WindowPlace> placeFrom(const QString& text);

/// `wanted` made small enough, and moved, to be with its frame within the one of `screens` on which
/// its middle is, or else on the first. `screens` are what is free of bars; there is at least one.
QRect fitted(const QRect& wanted, std::span<const QRect> screens);

/// The size inside the frame that a window can have at most on a screen with this free area.
QSize roomOn(const QRect& screen);

} // namespace app
