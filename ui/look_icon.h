// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

#include <string_view>

namespace ui {

/// The icon :/icons/KEY.svg, recoloured at every painting: black becomes the palette's text colour
/// (45 % of it when disabled), the drawing's orange the accent. Unknown keys give an empty picture.
QIcon icon(std::string_view key);

/// A picture of it in one colour.
QPixmap tinted(const QIcon& icon, const QSize& size, double pixelRatio, const QColor& colour);

} // namespace ui
