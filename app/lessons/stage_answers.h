// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"
#include "app/teaching/figure_frame.h"

namespace app {

/// An answer that is a part of the figure: an edge of the window or a piece of the line, with a
/// numbered disc beside it.
struct StageAnswer {
    enum class State : std::uint8_t { Open, Wrong, Right };

    int choice = 0; ///< index into the question's choices
    QLineF part{};  ///< in the picture
    QPointF disc{}; ///< its middle
    State state = State::Open;
};

/// The diameter of a disc in a figure of the usual type, in pixels.
constexpr double discSize = 30;
QRectF boxOfDisc(const QPointF& middle, const FigureFrame& frame);

/// The answers of the course's question in a figure of its line; empty if it has none, if they are
/// not parts of the figure, or if the figure does not show all of them. While the question is open
/// they say nothing about which one is right.
std::vector<StageAnswer> stageAnswers(const Course& course, const FigureFrame& frame);

/// Parts of the figure of a line with their discs, all of them open; the same.
std::vector<StageAnswer>
answersBeside(std::span<const std::variant<clipping::Edge, clipping::Segment>> parts,
              const TracedLine& tracedLine, const FigureFrame& frame);

/// The answer whose disc, or else whose part, is at a place of the picture.
std::optional<int> answerAt(const std::vector<StageAnswer>& answers, const QPointF& place,
                            const FigureFrame& frame);

} // namespace app
