// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/shown_steps.h"

#include <QEvent>
#include <QPointer>

class QAbstractButton;

namespace ui {

class MainWindow;
class PointerMark;

/// Acts in a window as a person does: by events of a pointer, which is seen, and of a keyboard. It
/// changes the drawing in no other way.
class Actor {
public:
    explicit Actor(MainWindow& window);
    ~Actor();
    Q_DISABLE_COPY_MOVE(Actor)

    const app::Point& at() const { return at_; } ///< of the pointer, in the drawing
    void pointAt(const app::Point& place);       ///< no event tells of it: over bars
    void move(const app::Point& place, Qt::KeyboardModifiers with);
    void press(Qt::KeyboardModifiers with, QEvent::Type type = QEvent::MouseButtonPress);
    void release(Qt::KeyboardModifiers with);
    void letGo(); ///< releases what is pressed
    void press(QAbstractButton& button);
    void release(QAbstractButton& button);
    void type(const app::ShownStep::Key& key);

    app::Point inDrawing(const app::Point& millimetres) const;
    QAbstractButton* button(const QString& name) const;      ///< that is seen; null: there is none
    app::Point placeOf(const QAbstractButton& button) const; ///< its middle, in the drawing

private:
    void send(QEvent::Type type, Qt::MouseButton button, Qt::KeyboardModifiers with);
    void showMark(bool pressed);

    MainWindow& window_;
    QPointer<PointerMark> mark_;
    app::Point at_{};
    Qt::MouseButtons down_{};
};

} // namespace ui
