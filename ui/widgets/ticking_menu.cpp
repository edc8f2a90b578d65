// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/ticking_menu.h"

#include <QKeyEvent>

namespace ui {

// Whether the active entry is a check box, which is now ticked or cleared.
bool TickingMenu::tick()
{
    QAction* action = activeAction();
    if (!action || !action->isCheckable() || !action->isEnabled())
        return false;
    action->trigger();
    return true;
}

void TickingMenu::mouseReleaseEvent(QMouseEvent* event)
{
    if (!rect().contains(event->position().toPoint()) || !tick())
        QMenu::mouseReleaseEvent(event);
}

void TickingMenu::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    const bool ticks = key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
    if (!ticks || !tick())
        QMenu::keyPressEvent(event);
}

} // namespace ui

#include "moc_ticking_menu.cpp"
