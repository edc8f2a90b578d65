// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

class QSettings;

// What is kept of the lessons from one start to the next.

namespace app {

/// Two points for each question of a lesson.
int mostPoints(const Lesson& lesson);
/// Whether so many points pass a lesson: three quarters of all, or more.
bool isPassed(int points, const Lesson& lesson);

/// The best points that were reached in a lesson, 0 to mostPoints(); nothing: it was never begun.
std::optional<int> bestPoints(const QSettings& settings, const Lesson& lesson);
/// Keeps the points of a lesson, unless better ones are kept already.
void keepPoints(QSettings& settings, const Lesson& lesson, int points);

} // namespace app
