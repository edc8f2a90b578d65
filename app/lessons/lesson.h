// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/teaching/narration.h"

#include <QStringList>

namespace app {

/// A question as a lesson writes it: the key of its kind (question.h) and its words.
struct QuestionSpec {
    QString kind;
    QStringList words;
};

/// The parts that a page shows beside the figure: only those that it explains or uses.
struct LessonParts {
    bool code = false;       ///< the pseudo-code
    bool variables = false;  ///< the table of variables
    bool operations = false; ///< the operations so far
    bool steps = false;      ///< the sentence and the timeline of the steps
    friend bool operator==(const LessonParts&, const LessonParts&) = default;
};

/// One page of a lesson: the text, and the traced line in the microscope. y points up.
struct LessonPage {
    QString text;   ///< markdown; it asks before it explains
    QString told{}; ///< markdown, shown after the question is settled
    QString hint{}; ///< of the question; replaces the hint of its kind
    TracedLine tracedLine{};
    /// Keys of families (families.h): each attempt has another line, from one of them. Empty: the
    /// line is always the same.
    QStringList families{};
    QString picture{}; ///< the key of a sample, whose picture stands above the text; may be empty
    QString step{};    ///< "first", "last", a number from 1, or the mark of a step: "cut"
    std::optional<QuestionSpec> question{};
    LessonParts shows{};
};

/// A lesson: a file in resources/lessons/, whose README explains the format.
struct Lesson {
    QString key; ///< the file's name without ".md"; stored when the lesson is done
    QString title;
    QString summary; ///< one sentence
    std::vector<LessonPage> pages;
};

/// The lessons, in the order in which they are taught.
const std::vector<Lesson>& lessons();

/// Parses a lesson; or returns what is wrong first and where: "line 12: …". All faults:
/// parse_lesson.h, and what only the lines show: check_lesson.h.
Result<Lesson> readLesson(const QString& key, const QString& text);

/// The step that a page asks for: an index into the narration's steps; empty if there is none.
std::optional<std::size_t> stepFor(const LessonPage& page, const Narration& narration);
/// The step that a page shows: that one, otherwise the last.
std::size_t wantedStep(const LessonPage& page, const Narration& narration);

} // namespace app
