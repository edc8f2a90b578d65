// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

#include <QPainter>
#include <QWidget>

namespace ui {

/// Around what a view shows. To be called when everything else is painted.
inline void paintFocusRing(QWidget& surface)
{
    QPainter painter(&surface);
    painter.setPen(QPen(lookOf(surface.palette()).selection, 2));
    painter.drawRect(surface.rect().adjusted(1, 1, -1, -1));
}

} // namespace ui
