// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/step_scene.h"

#include <QByteArray>
#include <QSizeF>

// The picture of a step for a web page: small, and without colours of its own.

namespace app {

/// The elements of a step's figure, for an <svg> with the viewBox of this size. Each has a class
/// that begins with "s-" for the colour of its stroke or "f-" for that of its area or text; the
/// rest of the name is that of a colour of FigureColours: "s-window". The page defines what they
/// look like, so that they can follow a dark desktop. Equal figures are equal bytes.
QByteArray figureSvg(const TraceStep& at, const QSizeF& size);

/// Where the figure's points are in it.
FigureFrame svgFrame(const TracedLine& tracedLine, const QSizeF& size);

/// The names of the classes' colours, without "s-" and "f-", and their colours on a ground.
std::vector<std::pair<const char*, QColor>> figureClasses(Ground ground);

} // namespace app
