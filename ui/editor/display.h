// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>

namespace ui {

class EditorApplication;

/// Why no window can be shown, judged by the environment variables, and what to do; empty if
/// nothing prevents it.
QString whyNoDisplay();

/// The application. Where windows cannot be shown (unreachable display, unknown platform) Qt would
/// abort; this function instead writes one sentence to standard error and exits with the code for a
/// failure.
std::unique_ptr<EditorApplication> startApplication(int& argc, char** argv);

/// Whether somebody can read standard error: a terminal is there, or another program listens. A
/// program that was started from a desktop has neither.
bool isErrorRead();

} // namespace ui
