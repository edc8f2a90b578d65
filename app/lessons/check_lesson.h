// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/parse_lesson.h"

namespace app {

/// The faults that need more than the text: whether each page's line can be shown, its step exists,
/// its question can be asked about its line and about lines that its families draw. Takes up to a
/// second.
std::vector<LessonFault> faultsOf(const ParsedLesson& parsed);

} // namespace app
