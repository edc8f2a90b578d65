// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QWidget>

namespace ui {

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
    void fit()
    {
        widget_.setFixedWidth(widget_.fontMetrics().horizontalAdvance(text_) + besides_);
    }

    QWidget& widget_;
    QString text_;
    int besides_;
};

} // namespace ui
