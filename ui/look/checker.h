// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

#include <QBrush>
#include <QPainter>
#include <QPixmap>

namespace ui {

/// The squares that stand for "nothing is behind the drawing".
inline QBrush checkerOf(const Look& look)
{
    constexpr int square = 8; // pixels
    QPixmap squares(2 * square, 2 * square);
    squares.fill(look.paper);
    QPainter painter(&squares);
    for (const int at : {0, square})
        painter.fillRect(at, at, square, square, look.hover);
    return squares;
}

} // namespace ui
