// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>

class QApplication;

namespace ui {

/// Why no window can be shown, as far as the environment tells, with what to do; empty: it says
/// nothing against it.
QString whyNoDisplay();

/// The application. Where there is no way to show windows (a display that cannot be reached, a
/// platform that does not exist) Qt would abort; this says one sentence on standard error and ends
/// the program with the exit code for what failed.
std::unique_ptr<QApplication> startApplication(int& argc, char** argv);

} // namespace ui
