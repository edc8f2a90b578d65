// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_colours.h"

namespace app {

FigureColours figureColours(Ground ground)
{
    return ground == Ground::Light ? FigureColours{.paper = 0xFFFFFF,
                                                   .text = 0x1B1E23,
                                                   .muted = 0x565D67,
                                                   .rule = 0xD0D4DA,
                                                   .border = 0xAEB5BF,
                                                   .window = 0xC2410C,
                                                   .highlight = 0x1D63C9,
                                                   .onHighlight = 0xFFFFFF,
                                                   .tint = 0xDCE8FA}
                                   : FigureColours{.paper = 0x1E2023,
                                                   .text = 0xE7E9EC,
                                                   .muted = 0xA6ACB6,
                                                   .rule = 0x3A3D44,
                                                   .border = 0x5C626C,
                                                   .window = 0xFF8F52,
                                                   .highlight = 0x5B9BFF,
                                                   .onHighlight = 0x10131A,
                                                   .tint = 0x2C3F60};
}

} // namespace app
