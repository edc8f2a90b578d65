// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace ui {

/// Gives the widget captionFont() of the program's font, and keeps it so: a font that is only set
/// is lost when a widget without a parent gets one, or the style sheet changes (Qt 6.4).
void wearCaption(QWidget& widget);

} // namespace ui
