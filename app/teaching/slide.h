// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/step_scene.h"
#include "app/view/algorithm_mark.h"

#include <QRectF>

class QPainter;

// A step as a 16:9 slide for a lecture: the picture, the sentence, the pseudo-code, the variables
// and the operations. Legible from the last row: no text is lower than 1/40 of the slide.

namespace app {

/// The content of a slide.
enum class SlideParts : std::uint8_t { All, Picture };

constexpr double slideWidth = 1280, slideHeight = 720; ///< in logical pixels

/// Paints a step into (0, 0) to (slideWidth, slideHeight). For a trace without steps: the line, the
/// window, and the reason.
void paintSlide(QPainter& painter, const TraceStep& at, SlideParts parts, Ground ground);

/// The place of a step's sentence.
QRectF sentenceArea();

/// "MD  Matthes-Drakopoulos, step 11 of 13".
QString slideTitle(const TracedLine& tracedLine, const Narration& narration, std::size_t step);
/// The sentence of a step, or why there are no steps.
QString slideSentence(const Narration& narration, std::size_t step);

} // namespace app
