// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

#include <QByteArray>

// The parts of a lesson's web page, in UTF-8. Every text in them is escaped.

namespace app {

/// A page about one of its lines: the figure, what the page shows beside it, and its question with
/// its answer. Until it is answered nothing tells more than the microscope does. `seed` draws the
/// line (attempt.h).
QByteArray lineHtml(const LessonPage& page, std::uint64_t seed);
/// The question's right answer on such a page, for paper; empty: no question.
QString rightAnswer(const LessonPage& page, std::uint64_t seed);
/// A picture as an element with its data, at most `width` pixels wide; empty if it has none.
QByteArray pictureHtml(const QString& picture, int width);
/// The sentences of the script, as an element of JSON.
QByteArray lessonWordsHtml(const Lesson& lesson);

} // namespace app
