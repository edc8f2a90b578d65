// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/key_field.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/window/keyboard.h"

#include <QKeyEvent>

namespace ui {

namespace {

bool isModifierAlone(int key)
{
    return (key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock) || key == Qt::Key_AltGr || key == 0
           || key == Qt::Key_unknown;
}

/// As a shortcut has it: the letter at the key's place on other keyboards, and a character that
/// needs Shift without it ("?", not "Shift+?"); a letter keeps its Shift.
QKeySequence pressedKey(const QKeyEvent& event)
{
    if (const auto key = keyAtItsPlace(event))
        return QKeySequence(*key);
    Qt::KeyboardModifiers with = event.modifiers() & ~Qt::KeypadModifier;
    const int key = event.key();
    const bool isLetter = key >= Qt::Key_A && key <= Qt::Key_Z;
    if (key > Qt::Key_Space && key < Qt::Key_Escape && !isLetter)
        with &= ~Qt::ShiftModifier;
    return QKeySequence(QKeyCombination(with, Qt::Key(key)));
}

} // namespace

KeyField::KeyField(QWidget* parent) : QLineEdit(parent)
{
    setReadOnly(true); // it never has a text
    setFixedHeight(space::fieldHeight);
    setPlaceholderText(Text::tr("Press the new key here"));
    setAccessibleName(Text::tr("New key"));
    setContextMenuPolicy(Qt::NoContextMenu);
}

/// All keys but Tab come here, also those of commands.
bool KeyField::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent* event)
{
    event->accept();
    if (event->key() == Qt::Key_Escape && event->modifiers() == Qt::NoModifier)
        emit left();
    else if (!isModifierAlone(event->key()))
        emit pressed(pressedKey(*event));
}

} // namespace ui

#include "moc_key_field.cpp"
