// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QString>

#include <optional>
#include <span>

namespace app {

/// The position of a window while it is not maximized: the corner of its frame and the size inside
/// the frame, in logical pixels.
struct WindowPlace {
    QRect rect;
    bool maximized = false;
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

/// "100,80 1280x800" or "100,80 1280x800 maximized": the form stored in the settings.
QString placeText(const WindowPlace& place);

/// Parses the text that placeText() writes. Empty unless the size is 1 to 100,000 pixels and the
/// corner is within ±100,000 pixels.
std::optional<WindowPlace> placeFrom(const QString& text);

/// Shrinks and moves `wanted` so that its frame lies within the screen that contains its centre, or
/// else within the first screen. `screens` holds the area free of bars of each screen, at least
/// one.
QRect fitted(const QRect& wanted, std::span<const QRect> screens);

/// The largest size inside the frame for a window on a screen with this free area.
QSize roomOn(const QRect& screen);

} // namespace app
