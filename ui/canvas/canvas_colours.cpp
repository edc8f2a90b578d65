// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_colours.h"

namespace ui {

CanvasColours canvasColours(const QPalette& palette)
{
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    const auto pick = [dark](QRgb light, QRgb night) { return QColor(dark ? night : light); };
    return {.around = pick(0xDEE1E5, 0x141517),
            .page = pick(0xFFFFFF, 0x1E2023),
            .pageBorder = pick(0xAEB5BF, 0x3A3D44),
            .ruler = pick(0xEFF0F2, 0x26282C),
            .rulerRule = pick(0xD0D4DA, 0x3A3D44),
            .rulerText = pick(0x565D67, 0xA6ACB6),
            .text = pick(0x1B1E23, 0xE7E9EC),
            .accent = pick(0xC2410C, 0xFF8F52),
            .onAccent = pick(0xFFFFFF, 0x1B1E23),
            .selection = pick(0x1D63C9, 0x5B9BFF),
            .onSelection = pick(0xFFFFFF, 0x10131A),
            .ghost = dark ? 0.34 : 0.32,
            .dark = dark};
}

} // namespace ui
