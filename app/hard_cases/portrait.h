// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"

#include <QColor>
#include <QRectF>

class QPainter;

namespace app {

struct PortraitColours {
    QColor paper, text, muted;
    QColor window, visible, differs; ///< the clip window, what is truly seen, a wrong answer
};
struct PortraitLook {
    PortraitColours colours;
    double unit = 1; ///< the size of a stroke: 1 in usual logical pixels
};

/// Paints a hard case, y up: the window, the line with its ends numbered, what of it is truly
/// visible; and, where one is given, a wrong answer. Nothing is painted outside the area, whatever
/// the numbers are.
void paintPortrait(QPainter& painter, const QRectF& area, const HardCase& hard,
                   const PortraitLook& look, const CaseAnswer* answer = nullptr);

/// Whether its distances are true; else only the order of the numbers is.
bool isToScale(const HardCase& hard, const CaseAnswer* answer = nullptr);

} // namespace app
