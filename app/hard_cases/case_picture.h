// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_answer.h"

#include <QColor>
#include <QRectF>

class QPainter;

namespace app {

struct CasePictureColours {
    QColor paper, text, muted;
    QColor window, visible, differs; ///< the clip window, the visible part, a wrong answer
};
struct CasePictureLook {
    CasePictureColours colours;
    double unit = 1; ///< size of a logical pixel
};

/// Paints a hard case, y up: the window, the line with its ends numbered, the exact visible part
/// and, if given, a wrong answer. Nothing is painted outside the area, whatever the numbers are.
void paintCasePicture(QPainter& painter, const QRectF& area, const HardCase& hard,
                      const CasePictureLook& look, const CaseAnswer* answer = nullptr);

/// Whether distances are to scale; otherwise only the order of the numbers is true.
bool isToScale(const HardCase& hard, const CaseAnswer* answer = nullptr);

} // namespace app
