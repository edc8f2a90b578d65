// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

#include <QFont>

namespace app {

/// The colours and font of a chart. All distances in the chart scale with the font size.
struct ChartLook {
    Ground ground;            ///< selects the algorithms' colours
    QColor paper;             ///< the background
    QColor text, muted, rule; ///< rule: grid lines
    QFont font;               ///< with a pixel size
};

/// For files: on white or on the dark theme's panel colour, in the application's font at 13 pixels.
ChartLook chartLook(Ground ground);

} // namespace app
