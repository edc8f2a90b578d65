// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/lessons/lesson.h"

#include <QByteArray>

namespace app {

/// The largest web page of a lesson, in bytes.
constexpr qsizetype mostLessonPageBytes = 300'000;

/// A lesson as one web page that needs no network and no other file: text, figures, and questions
/// that are answered in the page. Each question is about one of several lines, which the page draws
/// by lot; it has as many of them as have room. Equal lessons give equal bytes. Fails if the lesson
/// is too long for one page. Its look and its questions' script are in resources/lesson_page/.
Result<QByteArray> lessonHtml(const Lesson& lesson);
/// Writes it to a file, whole or not at all; what went wrong, in a sentence.
std::optional<QString> writeLessonPage(const Lesson& lesson, const QString& path);

} // namespace app
