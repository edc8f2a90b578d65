// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/actor.h"

#include "ui/showing/pointer_mark.h"
#include "ui/showing/shown_commands.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QShortcut>

#include <cmath>

namespace ui {

namespace {

QWidget& areaOf(MainWindow& window) { return *window.canvas().focusProxy(); }

/// A field or list that has the keyboard, else the drawing.
QWidget& receiverIn(MainWindow& window)
{
    QWidget* const focused = window.focusWidget();
    return focused && focused->isVisible() && window.isAncestorOf(focused) ? *focused
                                                                           : areaOf(window);
}

/// The shortcut of a page around the widget, such as the microscope's; null: none has these keys.
QShortcut* shortcutWith(const QWidget& receiver, const QKeySequence& keys)
{
    for (const QWidget* around = &receiver; around; around = around->parentWidget())
        for (auto* shortcut :
             around->findChildren<QShortcut*>(QString(), Qt::FindDirectChildrenOnly))
            if (shortcut->isEnabled() && shortcut->key() == keys)
                return shortcut;
    return nullptr;
}

void sendTo(QAbstractButton& button, QEvent::Type type, Qt::MouseButtons buttons)
{
    const QPointF middle = button.rect().center();
    QMouseEvent event(type, middle, button.mapToGlobal(middle), Qt::LeftButton, buttons, {});
    QCoreApplication::sendEvent(&button, &event);
}

} // namespace

Actor::Actor(MainWindow& window) : window_(window), mark_(new PointerMark(&window))
{
    const app::View& view = window.canvas().view();
    pointAt(view.toDrawing(view.size * 0.5));
    mark_->show();
}

Actor::~Actor() { delete mark_; }

void Actor::pointAt(const app::Point& place)
{
    at_ = place;
    showMark(false);
}

void Actor::move(const app::Point& place, Qt::KeyboardModifiers with)
{
    at_ = place;
    send(QEvent::MouseMove, Qt::NoButton, with);
}

void Actor::press(Qt::KeyboardModifiers with, QEvent::Type type)
{
    down_ = Qt::LeftButton;
    send(type, Qt::LeftButton, with);
}

void Actor::release(Qt::KeyboardModifiers with)
{
    down_ = {};
    send(QEvent::MouseButtonRelease, Qt::LeftButton, with);
}

void Actor::letGo()
{
    if (down_)
        release({});
}

void Actor::press(QAbstractButton& button)
{
    showMark(true);
    sendTo(button, QEvent::MouseButtonPress, Qt::LeftButton);
}

void Actor::release(QAbstractButton& button)
{
    showMark(false);
    sendTo(button, QEvent::MouseButtonRelease, {});
}

void Actor::send(QEvent::Type type, Qt::MouseButton button, Qt::KeyboardModifiers with)
{
    QWidget& area = areaOf(window_);
    const app::Point screen = window_.canvas().view().toScreen(at_);
    const QPointF place(std::round(screen.x), std::round(screen.y));
    showMark(bool(down_));
    QMouseEvent event(type, place, area.mapToGlobal(place), button, down_, with);
    QCoreApplication::sendEvent(&area, &event);
}

void Actor::showMark(bool pressed)
{
    if (!mark_)
        return;
    const app::Point screen = window_.canvas().view().toScreen(at_);
    mark_->setPressed(pressed);
    mark_->pointAt(areaOf(window_).mapTo(&window_, QPoint(qRound(screen.x), qRound(screen.y))));
    mark_->raise();
}

/// As a keyboard does: what has the focus first, then the shortcuts and commands with this key.
void Actor::type(const app::ShownStep::Key& key)
{
    const QPointer<QWidget> receiver(&receiverIn(window_));
    const QKeySequence keys(key.key);
    const auto send = [&](QEvent::Type type) {
        QKeyEvent event(type, key.key.key(), key.key.keyboardModifiers(), key.text);
        event.setAccepted(type != QEvent::ShortcutOverride);
        if (receiver)
            QCoreApplication::sendEvent(receiver, &event);
        return event.isAccepted();
    };
    const bool isTaken = send(QEvent::ShortcutOverride);
    if (!receiver)
        return;
    if (QShortcut* shortcut = isTaken ? nullptr : shortcutWith(*receiver, keys))
        return emit shortcut->activated();
    if (QAction* command = isTaken ? nullptr : commandWith(window_, *receiver, keys)) {
        if (mayBeShown(window_, *command))
            command->trigger();
        return;
    }
    if (key.key.keyboardModifiers().testFlag(Qt::ControlModifier))
        return; // a field would fill the clipboard
    send(QEvent::KeyPress);
    send(QEvent::KeyRelease);
}

app::Point Actor::inDrawing(const app::Point& millimetres) const
{
    const app::Page& page = window_.session().now().page();
    return page.min + millimetres / page.millimetresPerUnit();
}

QAbstractButton* Actor::button(const QString& name) const
{
    for (auto* button : window_.findChildren<QAbstractButton*>()) {
        const QStringList names{button->text().remove(u'&'), button->accessibleName(),
                                button->toolTip()};
        if (button->isVisible() && button->isEnabled() && names.contains(name))
            return button;
    }
    return nullptr;
}

app::Point Actor::placeOf(const QAbstractButton& button) const
{
    const QPoint middle = button.mapToGlobal(button.rect().center());
    const QPoint on = areaOf(window_).mapFromGlobal(middle);
    return window_.canvas().view().toDrawing({on.x(), on.y()});
}

} // namespace ui
