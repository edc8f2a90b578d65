// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/lessons/parse_lesson.h"

#include <QStringList>

#include <optional>
#include <vector>

// Lessons that people write: one .md file or a folder of them. resources/lessons/README.md explains
// the format. The files are untrusted: anything that is no lesson is refused with one sentence.

namespace app {

/// A lesson file as it was read.
struct LessonFile {
    QString path;
    std::optional<Lesson> lesson{};    ///< empty: it cannot be taught
    std::vector<LessonFault> faults{}; ///< line 0: of the file as a whole
    /// "lesson.md:12: …", a sentence for each fault; the name as `path` has it.
    QStringList sentences() const;
};

/// Whether a path is a folder or the name of a lesson file, which is not a drawing.
bool isLessonPath(const QString& path);

/// Reads lesson files, and of each folder the files *.md in the order of their names, without
/// README.md and without the folders in it. At least one entry for each path. The key of a lesson
/// is made of its title and questions, so that results are kept when a file moves or a text is
/// mended, and never are those of another lesson. A picture is a full path.
std::vector<LessonFile> readLessonFiles(const QStringList& paths, const Follower& follower = {});

} // namespace app
