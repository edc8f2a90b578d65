// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_marks.h"
#include "app/teaching/label_places.h"

namespace app {

/// A label of a figure and its place.
struct FigureLabel {
    enum class Tone : std::uint8_t { Plain, Highlighted, Window, Edge, RimEdge, HighlightedEdge };
    enum class Layout : std::uint8_t {
        Stacked, ///< the detail below the head
        Row,     ///< beside each other
        Column,  ///< the same, read upwards
    };
    Tone tone;
    QString head, detail{}; ///< the detail may be empty
    Layout layout = Layout::Stacked;
    QRectF box{};                    ///< with its padding
    std::optional<QPointF> leader{}; ///< the label's mark, if it is distant: a thin line joins them
    bool coversEdge = false;         ///< it lies on an edge: the ground below its text is covered
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

/// The size of a label's box, and the distance of its texts in a row.
QSizeF sizeOf(const FigureLabel& label, const FigureFrame& frame);
double gapInRow(const FigureFrame& frame);

/// Puts a label at the best free place, if any, and makes the place an obstacle.
bool placeLabel(std::vector<FigureLabel>& labels, FigureLabel label, std::span<const QRectF> places,
                LabelObstacles& obstacles);

} // namespace app
