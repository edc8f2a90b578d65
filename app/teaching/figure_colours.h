// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

#include <QColor>

namespace app {

/// The colours of a figure: the program's own colours, each with a single meaning.
struct FigureColours {
    QColor paper;             ///< the background
    QColor text, muted, rule; ///< text: the remaining part of the line; muted: discarded parts
    QColor border;            ///< the infinite lines of the edges
    QColor window;            ///< only the clip window
    QColor highlight, onHighlight,
        tint; ///< the subject of this step; text on it; its background in lists
};
FigureColours figureColours(Ground ground);

} // namespace app
