// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/held_input.h"

#include <QApplication>

namespace ui {

namespace {

bool isInput(const QEvent& event)
{
    switch (event.type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Shortcut:
    case QEvent::InputMethod:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::ContextMenu:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
    case QEvent::NativeGesture:
        return true;
    default:
        return false;
    }
}

} // namespace

HeldInput::~HeldInput() { qApp->removeEventFilter(this); }

void HeldInput::hold()
{
    if (!std::exchange(holding_, true))
        qApp->installEventFilter(this);
}

void HeldInput::drop() { held_.clear(); }

// notify(), unlike sendEvent(), leaves the mark of an event from outside, which a wheel event needs
// to reach the widget's parent.
void HeldInput::release()
{
    if (!std::exchange(holding_, false))
        return;
    qApp->removeEventFilter(this);
    const QPointer<HeldInput> self(this);
    while (self && !holding_ && !held_.empty()) {
        const Held next = std::move(held_.front());
        held_.pop_front();
        if (next.receiver)
            qApp->notify(next.receiver, next.event.get());
    }
}

bool HeldInput::eventFilter(QObject* receiver, QEvent* event)
{
    if (!isInput(*event) || QApplication::activeModalWidget())
        return false;
    held_.push_back({receiver, std::unique_ptr<QEvent>(event->clone())});
    return true;
}

} // namespace ui
