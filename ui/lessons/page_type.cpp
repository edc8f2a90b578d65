// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/page_type.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace ui {

namespace {

class PageFont : public QObject {
public:
    PageFont(QWidget& widget, double factor, QFont::Weight weight)
        : QObject(&widget), widget_(widget), factor_(factor), weight_(weight)
    {
        widget.installEventFilter(this);
        wear();
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
            wear();
        return false;
    }

private:
    void wear()
    {
        if (const QFont font = pageFont(factor_, weight_); widget_.font() != font)
            widget_.setFont(font);
    }

    QWidget& widget_;
    double factor_;
    QFont::Weight weight_;
};

} // namespace

QFont pageFont(double factor, QFont::Weight weight)
{
    QFont font = QApplication::font();
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * factor));
    else
        font.setPointSizeF(font.pointSizeF() * factor);
    font.setWeight(weight);
    return font;
}

void wearPageFont(QWidget& widget, double factor, QFont::Weight weight)
{
    new PageFont(widget, factor, weight);
}

} // namespace ui
