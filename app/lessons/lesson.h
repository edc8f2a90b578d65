// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/teaching/walk.h"

#include <QStringList>

namespace app {

/// A question of a lesson, as it is written there: the key of its kind (question.h) and its words.
struct Asking {
    QString kind;
    QStringList words;
};

/// One page of a lesson: what to read, and what the microscope shows meanwhile. y points up.
struct LessonPage {
    QString text;   ///< markdown; it asks before it tells
    QString told{}; ///< markdown, read once the question is settled
    QString hint{}; ///< of the question, instead of its kind's own
    Specimen specimen{};
    QString step{}; ///< "first", "last", a number from 1, or until which mark: "cut"
    std::optional<Asking> question{};
};

/// A lesson: a file in resources/lessons/, whose README says how one is written.
struct Lesson {
    QString key; ///< the file's name without ".md": remembered as done
    QString title;
    QString summary; ///< one sentence
    std::vector<LessonPage> pages;
};

/// The lessons, in the order in which they are taught.
const std::vector<Lesson>& lessons();

/// A lesson from its text; or what is wrong with it, and where: "line 12: …".
Result<Lesson> readLesson(const QString& key, const QString& text);

/// The step that a page wants to be seen: an index into the walk's moments.
std::size_t wantedStep(const LessonPage& page, const Walk& walk);

} // namespace app
