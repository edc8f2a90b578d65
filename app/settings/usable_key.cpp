// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/usable_key.h"

#include "app/base/text.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

/// They change what other keys do, also in any layout of a keyboard.
constexpr std::array modifierKeys{Qt::Key_Shift,   Qt::Key_Control,    Qt::Key_Meta,
                                  Qt::Key_Alt,     Qt::Key_AltGr,      Qt::Key_CapsLock,
                                  Qt::Key_NumLock, Qt::Key_ScrollLock, Qt::Key_Super_L,
                                  Qt::Key_Super_R, Qt::Key_Hyper_L,    Qt::Key_Hyper_R};
/// Keys with one meaning in the whole program: they move the focus, confirm, cancel, move the view.
constexpr std::array everywhere{Qt::Key_Escape, Qt::Key_Tab,   Qt::Key_Backtab,
                                Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space};
constexpr std::array arrows{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
constexpr std::array editing{Qt::Key_Insert, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Home,
                             Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown};

bool isOf(const auto& keys, Qt::Key key) { return std::ranges::find(keys, key) != keys.end(); }

bool isDigit(Qt::Key key) { return key >= Qt::Key_0 && key <= Qt::Key_9; }

/// It waits for a letter, or belongs to an input method.
bool composes(Qt::Key key)
{
    return (key >= Qt::Key_Dead_Grave && key <= Qt::Key_Dead_Longsolidusoverlay)
           || (key >= Qt::Key_Multi_key && key <= Qt::Key_Mode_switch);
}

bool opensContextMenu(Qt::Key key, bool alone, Qt::KeyboardModifiers with)
{
    return (alone && key == Qt::Key_Menu) || (with == Qt::ShiftModifier && key == Qt::Key_F10);
}

/// In Qt, the code of a key that types an ASCII character is that character.
bool isOneOf(QStringView characters, Qt::Key key)
{
    return key < 0x80 && characters.contains(QChar(char16_t(key)));
}

/// In Qt, keys that type a character have codes below those of special keys.
bool types(Qt::Key key) { return key < Qt::Key_Escape; }

} // namespace

QString whyNoShortcut(const QKeySequence& sequence, KeyedCommand::Scope scope)
{
    if (sequence.count() != 1 || sequence[0].key() == Qt::Key_unknown || sequence[0].key() == 0
        || isOf(modifierKeys, sequence[0].key()) || composes(sequence[0].key()))
        return Text::tr("This key cannot be a shortcut.");
    const Qt::Key key = sequence[0].key();
    const Qt::KeyboardModifiers with = sequence[0].keyboardModifiers();
    const bool alone = !(with & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const QString name = sequence.toString(QKeySequence::NativeText);
    if (alone && isOf(everywhere, key))
        return Text::tr("%1 has the same meaning everywhere and cannot be changed.").arg(name);
    if (opensContextMenu(key, alone, with))
        return Text::tr("%1 opens the context menu and cannot be changed.").arg(name);
    if (isOf(arrows, key) && !(with & (Qt::ControlModifier | Qt::MetaModifier)))
        return Text::tr("%1 moves what is chosen and cannot be changed.").arg(name);
    if (with == Qt::NoModifier && isDigit(key))
        return Text::tr("Digits choose the algorithm and cannot be changed.");
    if (scope == KeyedCommand::Scope::Canvas && alone && isOneOf(beginNumber, key) && !isDigit(key))
        return Text::tr("%1 begins a number on the canvas and cannot be changed.").arg(name);
    if (scope == KeyedCommand::Scope::Canvas && alone && isOneOf(beginPoint, key))
        return Text::tr("%1 begins a point on the canvas and cannot be changed.").arg(name);
    if (scope == KeyedCommand::Scope::Everywhere && alone && (types(key) || isOf(editing, key)))
        return Text::tr("%1 is needed in fields. Add Ctrl or Alt.").arg(name);
    return {};
}

} // namespace app
