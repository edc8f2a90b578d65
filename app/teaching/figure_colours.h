// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

#include <QColor>

namespace app {

/// What a figure is painted with: the program's own colours, each with its one meaning.
struct FigureColours {
    QColor paper;             ///< what it is painted on
    QColor text, muted, rule; ///< text: what is left of the line; muted: what is discarded
    QColor border;            ///< the lines that the edges lie on
    QColor window;            ///< the clip window, and nothing else
    QColor lit, onLit, tint;  ///< what this step is about; text on it; its ground in lists
};
FigureColours figureColours(Ground ground);

} // namespace app
