// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/swatch.h"

#include "app/view/visible_colour.h"

namespace ui {

QColor screenColour(const app::Colour& colour)
{
    return {colour.red, colour.green, colour.blue, colour.alpha};
}

app::Colour plainColour(const QColor& colour)
{
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

void paintSwatch(QPainter& painter, const QRect& square, const std::optional<app::Colour>& colour,
                 const Look& look)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QColor ground = look.base;
    painter.fillRect(square, ground);
    if (colour) {
        const QColor own(colour->red, colour->green, colour->blue, colour->alpha);
        painter.fillRect(square, own);
        QColor opaque = own;
        opaque.setAlpha(255);
        if (own.alpha() < 255) // the half on the left shows the colour without transparency
            painter.fillRect(QRect(square.topLeft(), QSize(square.width() / 2, square.height())),
                             opaque);
    }
    constexpr double enough = 3.0;
    if (!colour || colour->alpha < 255
        || app::contrast(plainColour(look.panel), {colour->red, colour->green, colour->blue})
               < enough) {
        painter.setPen(look.control);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(square.adjusted(0, 0, -1, -1));
    }
    if (!colour) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(look.control, 1.5));
        painter.drawLine(square.bottomLeft() + QPoint(1, 0), square.topRight() + QPoint(0, 1));
    }
    painter.restore();
}

namespace {

constexpr QSize iconSize(16, 16);
const QRect inIcon(1, 1, 14, 14);

} // namespace

QIcon swatchIcon(const std::optional<app::Colour>& colour, Swatch form)
{
    return paintedIcon(iconSize, [colour, form](QPainter& painter, const Look& look) {
        paintSwatch(painter, inIcon, colour, look);
        if (form == Swatch::Ring && colour)
            painter.fillRect(inIcon.adjusted(4, 4, -4, -4), look.base);
    });
}

QIcon mixedSwatchIcon()
{
    return paintedIcon(iconSize, [](QPainter& painter, const Look& look) {
        painter.setPen(look.control);
        painter.setBrush(look.base);
        painter.drawRect(inIcon.adjusted(0, 0, -1, -1));
        painter.fillRect(QRect(5, 7, 6, 2), look.control); // as in a half-checked box
    });
}

} // namespace ui
