// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QSize;
class QWidget;

namespace ui {

/// Gives a window the place that the settings remember under `key`, or its usual size, so that it
/// is within the screens there are; and as its smallest size `smallest`, or what the screen has.
void restorePlace(QWidget& window, const QString& key, const QSize& usual, const QSize& smallest);

/// Makes it small enough for the screens there are now, and moves it onto one if it is on none.
void fitToScreens(QWidget& window);

/// Remembers where it is under `key`.
void rememberPlace(const QWidget& window, const QString& key);

} // namespace ui
