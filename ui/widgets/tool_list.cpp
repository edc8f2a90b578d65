// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tool_list.h"

#include <QKeyEvent>

#include <utility>

namespace ui {

void ToolList::showPopup()
{
    open_ = true;
    QComboBox::showPopup();
}

// Queued, because Qt signals the selection after it hides the list. Qt also calls this for a closed
// list.
void ToolList::hidePopup()
{
    QComboBox::hidePopup();
    if (std::exchange(open_, false))
        QMetaObject::invokeMethod(this, &ToolList::done, Qt::QueuedConnection);
}

void ToolList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        emit done();
    else
        QComboBox::keyPressEvent(event);
}

} // namespace ui

#include "moc_tool_list.cpp"
