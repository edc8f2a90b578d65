// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

// The parser of lesson files. It is strict and reads on after a fault, so that a teacher sees all
// of them at once. Files of other people are untrusted: everything in them has a limit.

namespace app {

/// The version of lesson files that this program reads and its own lessons have.
constexpr int lessonVersion = 1;
constexpr std::size_t mostLessonPages = 100;

/// A fault of a lesson file.
struct LessonFault {
    int line = 0;         ///< from 1
    QString sentence;     ///< “:: step seven” is not understood. …
    bool prevents = true; ///< false: the lesson can be taught all the same
};

/// The lines at which a page's parts stand, from 1; 0: it has none.
struct PageLines {
    int first = 0, look = 0, draw = 0, step = 0, picture = 0, ask = 0;
};

struct ParsedLesson {
    Lesson lesson;
    std::vector<PageLines> lines;    ///< one for each page
    std::vector<LessonFault> faults; ///< in the order of their lines; reading ends at 20
};
ParsedLesson parseLesson(const QString& key, const QString& text);

} // namespace app
