// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

class QSettings;

// The scores of lessons, stored between program starts.

namespace app {

/// Two points for each question of a lesson.
int mostPoints(const Lesson& lesson);
/// Whether these points pass a lesson: at least three quarters of all.
bool isPassed(int points, const Lesson& lesson);

/// The best points reached in a lesson, 0 to mostPoints(); empty: it was never started.
std::optional<int> bestPoints(const QSettings& settings, const Lesson& lesson);
/// Stores the points of a lesson, unless better ones are stored already.
void keepPoints(QSettings& settings, const Lesson& lesson, int points);

} // namespace app
