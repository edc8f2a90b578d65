// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/menu_keys.h"

#include <QApplication>
#include <QEvent>
#include <QMenu>

namespace ui {

bool MenuKeys::eventFilter(QObject* receiver, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride
        || !qobject_cast<QMenu*>(QApplication::activePopupWidget()))
        return QObject::eventFilter(receiver, event);
    event->accept();
    return true;
}

} // namespace ui
