// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace ui {

/// The colours of everything that the canvas draws itself (look.md section 2).
struct CanvasColours {
    QColor around; ///< around the page
    QColor page;   ///< shown page; white where the drawing is shown as printed
    QColor pageBorder;
    QColor ruler, rulerRule, rulerText;
    QColor text;                   ///< strong text and the pointer's marks on the rulers
    QColor accent, onAccent;       ///< the clip window, and nothing else
    QColor selection, onSelection; ///< chosen, lit or focused
    double ghost;                  ///< opacity of the removed part
    bool dark;                     ///< inks that would not be seen are mirrored in lightness
};

/// Those of the light or the dark theme, whichever the palette is.
CanvasColours canvasColours(const QPalette& palette);

} // namespace ui
