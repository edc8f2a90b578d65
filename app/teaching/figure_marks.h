// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/step_scene.h"

#include <vector>

namespace app {

/// A point worth a mark and a label.
struct FigureMark {
    enum class Shape : std::uint8_t { End, FarEnd, Cut, Candidate };
    enum class Tone : std::uint8_t { Strong, Muted, Highlighted };
    Shape shape;
    Tone tone;
    Point point;          ///< of the drawing
    QPointF place;        ///< in the picture; for an end outside the picture: on its border
    double angle;         ///< of a far end: its direction in degrees, as in QLineF
    QString head, detail; ///< the two lines of its label; both empty: no label
};

/// The radius of a mark, in the picture's units.
double radiusOf(const FigureMark& mark, const FigureFrame& frame);

/// All marks of a step: first the ends, then the cuts in order, then candidate cuts.
std::vector<FigureMark> figureMarks(const TracedLine& tracedLine, const StepScene& scene,
                                    const FigureFrame& frame);

/// "−9.0625, 75": six significant digits each.
QString pointText(const Point& point);

} // namespace app
