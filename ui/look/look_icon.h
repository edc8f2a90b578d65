// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

#include <QIcon>
#include <QPainter>

#include <functional>
#include <string_view>

namespace ui {

/// The icon :/icons/KEY.svg, recoloured each time it is painted: black becomes the palette's text
/// colour (45 % opacity when disabled), orange the accent. An unknown key gives an empty picture.
QIcon icon(std::string_view key);

/// An icon of this size in logical pixels, painted by `paint` in the look that the program has
/// then.
QIcon paintedIcon(const QSize& size,
                  std::function<void(QPainter& painter, const Look& look)> paint);

/// The icon in one colour.
QPixmap tinted(const QIcon& icon, const QSize& size, double pixelRatio, const QColor& colour);

} // namespace ui
