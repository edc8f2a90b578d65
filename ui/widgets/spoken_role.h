// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QWidget>

namespace ui {

/// Tells screen readers what a widget of our own is: Qt says only of its own classes whether they
/// are a button, a list or a tool bar. To be called in the widget's constructor.
void setSpokenRole(QWidget& widget, QAccessible::Role role);

/// Has every list and table tell screen readers its current row when it gets the focus, as it tells
/// them every later one: Qt names the list alone. Once for the application.
void speakRowsInFocus();

} // namespace ui
