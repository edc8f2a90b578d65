// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tool_list.h"

#include <QAbstractItemView>
#include <QKeyEvent>

#include <utility>

namespace ui {

bool ToolList::takesLetter(QEvent& event)
{
    if (event.type() != QEvent::ShortcutOverride)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const bool isCommand = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
    const bool takes = !isCommand && !key.text().isEmpty() && key.text().front().isPrint();
    event.setAccepted(takes);
    return takes;
}

bool ToolList::eventFilter(QObject* watched, QEvent* event)
{
    return takesLetter(*event) || QComboBox::eventFilter(watched, event);
}

void ToolList::showPopup()
{
    open_ = true;
    view()->installEventFilter(this); // only now: Qt makes the view when it is asked for
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
