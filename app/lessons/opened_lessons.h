// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson_files.h"

// The lessons that were opened in this run of the program, beside those that come with it. They
// belong to all windows, and are used by the interface's thread only. A lesson has a number that
// never changes: first those of lessons(), then the opened ones in the order of their opening.

namespace app {

/// Lessons of one folder, or single files of one, under their heading in the list.
struct LessonGroup {
    QString folder;                   ///< a full path
    QString heading;                  ///< the folder's name
    std::vector<std::size_t> lessons; ///< their numbers
    QStringList notes;                ///< what is wrong with its files, a sentence each
};
const std::vector<LessonGroup>& openedLessons();

/// Whether this folder or file was opened.
bool isOpened(const QString& path);

/// How often lessons were added or closed: a view with another number is outdated.
int lessonOpenings();

/// Adds what was read. Files of a folder that was opened before replace its lessons of the same
/// file; a lesson that someone is in keeps its number, and ends as it was. Returns the number of
/// the first lesson that was added; empty: there was none.
std::optional<std::size_t> addOpenedLessons(std::vector<LessonFile> files);

/// Takes a folder's lessons out of the list; the files stay. A lesson that someone is in ends as it
/// was.
void closeOpenedLessons(const QString& folder);

/// The lesson with this number; null if there is none.
const Lesson* lessonAt(std::size_t number);
/// The lesson that follows in the program's lessons, or in the group; empty: it is the last.
std::optional<std::size_t> lessonAfter(std::size_t number);
/// Its place among them, from 1.
std::size_t placeOfLesson(std::size_t number);

} // namespace app
