// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyCombination>

#include <optional>

class QKeyEvent;

namespace ui {

/// What the key that was pressed is on an American keyboard, by its place: for keys that have no
/// Latin letter or digit of their own, as the digits of a French keyboard and all letters of a
/// Greek one, where a shortcut with a letter or a digit could not be typed. Nothing: it says itself
/// what it is, or its place is not known (only Linux's are).
std::optional<QKeyCombination> keyAtItsPlace(const QKeyEvent& event);

} // namespace ui
