// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include <string_view>

namespace ui {

/// The icon :/icons/KEY.svg, recoloured at every painting: black becomes the palette's text colour
/// (45 % of it when disabled), the drawing's orange the accent. Unknown keys give an empty picture.
QIcon icon(std::string_view key);

} // namespace ui
