// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

#include <QFont>

namespace app {

/// What a chart is painted with. All its distances go with the size of the font.
struct ChartLook {
    Ground ground;            ///< which of the algorithms' colours
    QColor paper;             ///< what it is painted on
    QColor text, muted, rule; ///< rule: lines of the grid
    QFont font;               ///< with a pixel size
};

/// For files: on white, or on the dark theme's panel, in the application's font, 13 pixels.
ChartLook chartLook(Ground ground);

} // namespace app
