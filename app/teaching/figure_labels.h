// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_marks.h"

namespace app {

/// A label of a figure and its place.
struct FigureLabel {
    enum class Tone : std::uint8_t { Plain, Highlighted, Window, Edge, HighlightedEdge };
    Tone tone;
    QString head, detail;            ///< detail: a second line; may be empty
    QRectF box;                      ///< with its padding
    std::optional<QPointF> leader{}; ///< the label's mark, if it is distant: a thin line joins them
};

/// The labels of a step: inside the picture, without overlap with each other, a mark or the line.
/// Labels without room are left out, the least important ones first.
std::vector<FigureLabel> figureLabels(const TracedLine& tracedLine, const Narration& narration,
                                      const StepScene& scene, const FigureFrame& frame);

/// The fonts of a label's two lines.
QFont headFont(const FigureFrame& frame, FigureLabel::Tone tone);
QFont detailFont(const FigureFrame& frame);
/// The padding around the text of a label.
QMarginsF paddingOf(const FigureFrame& frame, FigureLabel::Tone tone);

/// The part of an edge's infinite line inside the picture; empty if it is not visible.
std::optional<QLineF> edgeLine(clipping::Edge edge, const TracedLine& tracedLine,
                               const FigureFrame& frame);
/// The window in the picture; a line or a point if it has no size.
QRectF windowBox(const TracedLine& tracedLine, const FigureFrame& frame);

} // namespace app
