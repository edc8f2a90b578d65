// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk_step.h"
#include "app/view/algorithm_mark.h"

#include <QRectF>

class QPainter;

// A step as a page of its own, 16:9, for a lecture: the picture, the sentence, the pseudo-code, the
// variables and the operations. It is read from the last row: no text is lower than a fortieth of
// the slide.

namespace app {

/// What is on a slide.
enum class SlideParts : std::uint8_t { All, Picture };

constexpr double slideWidth = 1280, slideHeight = 720; ///< in logical pixels

/// Paints a step into (0, 0) to (slideWidth, slideHeight). Of a walk without moments: the line, the
/// window, and why there is nothing to see.
void paintSlide(QPainter& painter, const WalkStep& at, SlideParts parts, Ground ground);

/// Where the sentence of a step is.
QRectF sentenceArea();

/// "MD  Matthes-Drakopoulos, step 11 of 13".
QString slideTitle(const Specimen& specimen, const Walk& walk, std::size_t step);
/// What happens at a step; why there is none.
QString slideSentence(const Walk& walk, std::size_t step);

} // namespace app
