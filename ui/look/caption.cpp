// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/caption.h"

#include "ui/look/look.h"

#include <QApplication>
#include <QEvent>

namespace ui {
namespace {

class Caption : public QObject {
public:
    explicit Caption(QWidget& widget) : QObject(&widget), widget_(widget)
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
        if (const QFont caption = captionFont(QApplication::font()); widget_.font() != caption)
            widget_.setFont(caption);
    }

    QWidget& widget_;
};

} // namespace

void wearCaption(QWidget& widget) { new Caption(widget); }

} // namespace ui
