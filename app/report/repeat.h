// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

#include <QStringList>

namespace app {

/// The words after the program's name that measure the same again: "bench", "--runs=20", ... A
/// drawing is named without its folder.
QStringList wordsToRepeat(const Study& study);

/// The command that repeats the study and writes its report: "clearcut bench --paper ...".
QString commandToRepeat(const Study& study);

} // namespace app
