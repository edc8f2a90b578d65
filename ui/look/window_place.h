// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QSize;
class QWidget;

namespace ui {

/// Gives a window the geometry that the settings store under `key`, or else the size `usual`,
/// fitted to the available screens. Its minimum size becomes `smallest`, or the screen's size if
/// that is smaller.
void restorePlace(QWidget& window, const QString& key, const QSize& usual, const QSize& smallest);

/// Shrinks the window to the available screens, and moves it onto one if it is on none.
void fitToScreens(QWidget& window);

/// Stores the window's geometry in the settings under `key`.
void rememberPlace(const QWidget& window, const QString& key);

} // namespace ui
