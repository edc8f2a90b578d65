// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/step_scene.h"

#include <vector>

namespace app {

/// A point worth a mark and a label.
struct FigureMark {
    enum class Shape : std::uint8_t { End, FarEnd, Cut, Candidate };
    enum class Tone : std::uint8_t { Strong, Muted, Lit };
    Shape shape;
    Tone tone;
    Point point;          ///< of the drawing
    QPointF place;        ///< in the picture; of an end outside of it: at the border
    double angle;         ///< of a far end: where it lies, in degrees as QLineF has them
    QString head, detail; ///< its label's two lines; both empty: it has none
};

/// The radius of a mark, in the picture's units.
double radiusOf(const FigureMark& mark, const FigureFrame& frame);

/// All marks of a step: the ends first, then the cuts in their order, then what may be a cut.
std::vector<FigureMark> figureMarks(const Specimen& specimen, const StepScene& scene,
                                    const FigureFrame& frame);

/// "−9.0625, 75": six digits each.
QString pointText(const Point& point);

} // namespace app
