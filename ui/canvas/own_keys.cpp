// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/own_keys.h"

#include "app/base/text.h"
#include "app/document/window_operations.h"

#include <algorithm>

namespace ui {

bool isPressed(const QKeySequence& key, const QKeyEvent& event)
{
    if (key.count() != 1)
        return false;
    const Qt::KeyboardModifiers with = event.modifiers() & ~Qt::KeypadModifier;
    if (key[0] == QKeyCombination(with, Qt::Key(event.key())))
        return true;
    constexpr int afterSigns = 0x80; // in Qt, the code of an ASCII character is that character
    const int code = key[0].key();
    const bool isSign = code < afterSigns && !QChar(code).isLetterOrNumber();
    return isSign && key[0].keyboardModifiers() == Qt::NoModifier
           && !(with & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
           && event.text() == QChar(code);
}

bool OwnKeys::isOf(const QKeyEvent& event, std::string_view command,
                   const QKeySequence& standard) const
{
    const auto told = keys_.find(app::latin(command));
    if (told == keys_.end())
        return isPressed(standard, event);
    return std::ranges::any_of(*told,
                               [&event](const QKeySequence& key) { return isPressed(key, event); });
}

bool OwnKeys::isOfWindow(const QKeyEvent& event) const
{
    const auto isOperation = [&](const app::WindowOperationInfo& each) {
        return isOf(event, each.key, QKeySequence(each.letter));
    };
    return std::ranges::any_of(app::windowOperations(), isOperation)
           || isOf(event, keepOutside, QKeySequence(Qt::Key_X));
}

} // namespace ui
