// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/key_tip.h"

#include "ui/look/text.h"

namespace ui {

KeyNews& KeyNews::get()
{
    static KeyNews news;
    return news;
}

void KeyNews::tell(const app::KeysInUse& keys)
{
    app::tellKeysInUse(keys);
    emit changed();
}

void followKeys(QObject& widget, const std::function<void()>& refresh)
{
    QObject::connect(&KeyNews::get(), &KeyNews::changed, &widget, refresh);
    refresh();
}

void setKeyTip(QWidget& widget, const QString& text)
{
    followKeys(widget, [&widget, text] { widget.setToolTip(app::withKeys(text)); });
}

QString nameWithKey(const QString& name, const QAction& action)
{
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? name : Text::tr("%1 (%2)").arg(name, key);
}

} // namespace ui

#include "moc_key_tip.cpp"
