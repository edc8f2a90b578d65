// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/pointer_mark.h"

#include "ui/look/look.h"

#include <QPainter>
#include <QPainterPath>

namespace ui {

namespace {

constexpr int side = 52; // pixels; the tip is in the middle
constexpr double ring = 14;

QPainterPath arrow()
{
    QPainterPath path({0, 0});
    for (const QPointF& p :
         {QPointF(0, 19), {4.6, 15}, {7.6, 22}, {10.8, 20.6}, {7.8, 13.8}, {14, 13.4}})
        path.lineTo(p);
    path.closeSubpath();
    return path;
}

} // namespace

PointerMark::PointerMark(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("pointer-mark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFixedSize(side, side);
}

void PointerMark::pointAt(const QPoint& tip) { move(tip - QPoint(side / 2, side / 2)); }

void PointerMark::setPressed(bool pressed)
{
    pressed_ = pressed;
    update();
}

void PointerMark::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(side / 2.0, side / 2.0);
    if (pressed_) {
        painter.setPen(QPen(look.selection, 2.5));
        painter.drawEllipse(QPointF(0, 0), ring, ring);
    }
    painter.setPen(QPen(look.onSelection, 1.5));
    painter.setBrush(look.selection);
    painter.drawPath(arrow());
}

} // namespace ui
