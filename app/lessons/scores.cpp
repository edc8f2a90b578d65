// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/scores.h"

#include <QSettings>

#include <algorithm>

namespace app {

namespace {

QString keyOf(const Lesson& lesson) { return QStringLiteral("lessons/points/") + lesson.key; }

} // namespace

int mostPoints(const Lesson& lesson)
{
    return 2 * int(std::ranges::count_if(lesson.pages, [](const LessonPage& page) {
               return page.question.has_value();
           }));
}

bool isPassed(int points, const Lesson& lesson) { return 4 * points >= 3 * mostPoints(lesson); }

std::optional<int> bestPoints(const QSettings& settings, const Lesson& lesson)
{
    bool isNumber = false;
    const int points = settings.value(keyOf(lesson)).toInt(&isNumber);
    return isNumber ? std::optional(std::clamp(points, 0, mostPoints(lesson))) : std::nullopt;
}

void keepPoints(QSettings& settings, const Lesson& lesson, int points)
{
    if (points > bestPoints(settings, lesson).value_or(-1))
        settings.setValue(keyOf(lesson), std::clamp(points, 0, mostPoints(lesson)));
}

} // namespace app
