// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_marks.h"

namespace app {

/// A label of a figure, and where it is.
struct FigureLabel {
    enum class Tone : std::uint8_t { Plain, Lit, Window, Edge, LitEdge };
    Tone tone;
    QString head, detail;            ///< detail: a second line; may be empty
    QRectF box;                      ///< with its padding
    std::optional<QPointF> leader{}; ///< the mark that it lies apart from: a thin line joins them
};

/// The labels of a step: inside the picture, none over another, a mark or the line. One for which
/// there is no room is left out, the least telling ones first.
std::vector<FigureLabel> figureLabels(const Specimen& specimen, const Walk& walk,
                                      const StepScene& scene, const FigureFrame& frame);

/// The fonts of a label's two lines.
QFont headFont(const FigureFrame& frame, FigureLabel::Tone tone);
QFont detailFont(const FigureFrame& frame);
/// What is around the text of a label.
QMarginsF paddingOf(const FigureFrame& frame, FigureLabel::Tone tone);

/// Where an edge's line runs through the picture; nothing if it cannot be seen.
std::optional<QLineF> edgeLine(clipping::Edge edge, const Specimen& specimen,
                               const FigureFrame& frame);
/// The window as it is seen; a line or a point where it has no size.
QRectF windowBox(const Specimen& specimen, const FigureFrame& frame);

} // namespace app
