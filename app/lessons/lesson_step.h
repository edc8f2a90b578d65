// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// Whether a word names the step of a page: "first", "last", "7", "cut" or "cut-2".
bool isLessonStep(const QString& word);

} // namespace app
