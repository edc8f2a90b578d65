// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/answer_cover.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int eye = 16, besideEye = 6; // pixels

QString words() { return Text::tr("covered until you answer"); }

} // namespace

AnswerCover::AnswerCover(QWidget* over) : QWidget(over)
{
    setAccessibleName(words());
    setFont(captionFont(over->font()));
    over->installEventFilter(this);
    setGeometry(over->rect());
}

bool AnswerCover::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void AnswerCover::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), lookOf(palette()).panel);
    paintAnswerCover(painter, rect().adjusted(space::dockMargin, 6, -space::dockMargin, -6),
                     palette());
}

void paintAnswerCover(QPainter& painter, const QRect& area, const QPalette& palette)
{
    const Look& look = lookOf(palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.hover);
    painter.drawRoundedRect(area, space::radius, space::radius);
    const int text = painter.fontMetrics().horizontalAdvance(words());
    const bool both = eye + besideEye + text + 2 * besideEye <= area.width();
    const int left = area.center().x() - (both ? eye + besideEye + text : eye) / 2;
    icon("eye-closed").paint(&painter, QRect(left, area.center().y() - eye / 2, eye, eye));
    painter.setPen(look.muted);
    if (both)
        painter.drawText(QRect(left + eye + besideEye, area.top(), text + besideEye, area.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, words());
    painter.restore();
}

} // namespace ui

#include "moc_answer_cover.cpp"
