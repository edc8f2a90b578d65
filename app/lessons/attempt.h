// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"
#include "app/lessons/question.h"

#include <cstdint>

// What is new in each attempt at a lesson: the lines of its pages and the order of the choices, so
// that nothing that was seen in an earlier attempt answers a question. Equal seeds give equal
// attempts; with the seed 0 everything is as the lesson's file has it.

namespace app {

/// A page with a line drawn from its families, about which its question can be asked. The page
/// itself if it names no family, or if none of many lines fits.
LessonPage drawnPage(const LessonPage& page, std::uint64_t seed);

/// A question with its choices in another order; the same for all questions of as many choices.
Question inNewOrder(Question question, std::uint64_t seed);

} // namespace app
