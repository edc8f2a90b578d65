// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QWidget>

#include <functional>

namespace ui {

/// Calls `refresh` when the language of the numbers that a widget shows has changed.
class LanguageFollower : public QObject {
public:
    LanguageFollower(QWidget& widget, std::function<void()> refresh)
        : QObject(&widget), refresh_(std::move(refresh))
    {
        widget.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::LocaleChange)
            QMetaObject::invokeMethod( // when its parts have followed
                this, [this] { refresh_(); }, Qt::QueuedConnection);
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> refresh_;
};

} // namespace ui
