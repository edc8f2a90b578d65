// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>

class QWidget;

namespace ui {

/// The sizes of type on a lesson's page, as multiples of the program's.
namespace pageType {
constexpr double title = 2.0, question = 1.3, text = 1.23;
} // namespace pageType

/// The program's font in another size and weight.
QFont pageFont(double factor, QFont::Weight weight = QFont::Normal);
/// Gives the widget that font, and keeps it so when the program's font or style sheet changes.
void wearPageFont(QWidget& widget, double factor, QFont::Weight weight = QFont::Normal);

} // namespace ui
