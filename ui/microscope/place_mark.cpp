// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/place_mark.h"

#include "app/practice/stage.h"
#include "ui/look/look.h"
#include "ui/microscope/microscope_view.h"

#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace ui {

PlaceMark::PlaceMark(app::Practice& practice, MicroscopeView& view)
    : QWidget(&view), practice_(practice), view_(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    view.installEventFilter(this);
    connect(&practice, &app::Practice::changed, this, &PlaceMark::follow);
    connect(&practice, &app::Practice::draftChanged, this, &PlaceMark::follow);
    connect(&view, &MicroscopeView::framed, this, &PlaceMark::follow);
    connect(&view, &MicroscopeView::reframed, this, &PlaceMark::follow);
    follow();
}

void PlaceMark::follow()
{
    setGeometry(view_.rect());
    place_ = app::markOf(practice_, view_.frame());
    drags_ = drags_ && app::isPlacing(practice_);
    setVisible(place_.has_value());
    update();
}

bool PlaceMark::moveTo(const QMouseEvent& event)
{
    const auto at = app::isPlacing(practice_)
                        ? app::placeNear(event.position(), practice_, view_.frame())
                        : std::nullopt;
    if (at)
        practice_.setDraft(*at);
    return at.has_value();
}

bool PlaceMark::eventFilter(QObject* watched, QEvent* event)
{
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::FontChange:
        follow();
        break;
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonPress:
        drags_ = mouse->button() == Qt::LeftButton && moveTo(*mouse);
        return drags_;
    case QEvent::MouseMove:
        if (drags_)
            moveTo(*mouse);
        return drags_;
    case QEvent::MouseButtonRelease:
        return std::exchange(drags_, false);
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void PlaceMark::paintEvent(QPaintEvent*)
{
    if (!place_)
        return;
    const Look& look = lookOf(palette());
    const double unit = view_.frame().unit(), radius = 9 * unit;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.base, 2 * unit));
    painter.setBrush(practice_.isOpen() ? look.selection : look.good);
    painter.drawPolygon(QPolygonF{*place_ + QPointF(0, -radius), *place_ + QPointF(radius, 0),
                                  *place_ + QPointF(0, radius), *place_ + QPointF(-radius, 0)});
}

} // namespace ui

#include "moc_place_mark.cpp"
