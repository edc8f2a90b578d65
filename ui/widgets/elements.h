// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QFrame>
#include <QWidget>

#include <functional>

namespace ui {

/// A line one logical pixel wide between two parts of a window.
inline QFrame* rule(Qt::Orientation orientation)
{
    auto* line = new QFrame;
    line->setFrameShape(orientation == Qt::Horizontal ? QFrame::HLine : QFrame::VLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    line->setLineWidth(1);
    return line;
}

/// Lets a widget keep its place while it is hidden, so that nothing moves.
inline void keepPlaceWhenHidden(QWidget& widget)
{
    QSizePolicy policy = widget.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget.setSizePolicy(policy);
}

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

/// Keeps a widget as wide as a text and some more pixels, also after its font has changed.
class RoomForText : public QObject {
public:
    RoomForText(QWidget& widget, const QString& text, int besides)
        : QObject(&widget), widget_(widget), text_(text), besides_(besides)
    {
        fit();
        widget.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange)
            fit();
        return false;
    }

private:
    void fit() { widget_.setFixedWidth(widget_.fontMetrics().horizontalAdvance(text_) + besides_); }

    QWidget& widget_;
    QString text_;
    int besides_;
};

} // namespace ui
