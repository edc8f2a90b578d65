// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace ui {

/// `clearcut [--renderer R] [FILE]`: the editor, until its window is closed. With --screenshot it
/// paints its window without a screen into a PNG, in full quality, and ends. `arguments` are argv
/// without the program's name. Returns the exit code: 1 without a display or the file, 2 for
/// wrong usage.
int runEditor(int argc, char** argv, const QStringList& arguments);

} // namespace ui
