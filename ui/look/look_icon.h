// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

#include <string_view>

namespace ui {

/// The icon :/icons/KEY.svg, recoloured each time it is painted: black becomes the palette's text
/// colour (45 % opacity when disabled), orange the accent. An unknown key gives an empty picture.
QIcon icon(std::string_view key);

/// The icon in one colour.
QPixmap tinted(const QIcon& icon, const QSize& size, double pixelRatio, const QColor& colour);

} // namespace ui
